// Servos that are stable at every step.
//
// A servo is a torque of the step's beginning while that is stable, as far as the inertia of the
// joint's child says. A firmer one is a motor of the library with a softness (CFM), which makes it
// the servo at the velocity v' of the end of the step, together with everything else that moves:
//   torque = stiffness·(position − q − dt·v') − damping·v' = slope·(target − v').
#pragma once

#include <ode/ode.h>

#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/rigid_parts.hpp>

namespace eagerx::models {

/// A joint before the step.
struct JointStep {
  double position, velocity;
  double inertia;  // inertia_of_joint()
  double step_s;
  double cfm;  // of the world

  /// Whether a torque that falls by `slope` for each rad/s turns the joint around in a step.
  constexpr bool is_firm(double slope) const { return step_s * slope > inertia; }
};

/// A torque of the step's beginning; of a firm servo as far as the inertia of the child alone says.
constexpr double servo_torque(const JointServo& servo, const JointStep& joint) {
  const double slope = servo.damping + joint.step_s * servo.stiffness;
  if (!joint.is_firm(slope)) return servo.torque(joint.position, joint.velocity);
  const double wanted =
      (servo.stiffness * (servo.position - joint.position) - slope * joint.velocity) *
      joint.inertia / (joint.inertia + joint.step_s * slope);
  return eagerx::max(-servo.max_torque, eagerx::min(wanted, servo.max_torque));
}

/// All zero where the servo is not a constraint.
class ServoConstraint {
 public:
  constexpr bool holds() const { return slope_ > 0.0; }

  /// Sets the library's motor; false if the servo is not a constraint in this step. At a stop the
  /// library would add the motor's whole torque, so there it is none.
  bool hold(dJointID id, const RigidJoint& of, const JointServo& servo, double strength,
            const JointStep& joint) {
    const double slope = strength * (servo.damping + joint.step_s * servo.stiffness) + of.damping;
    const bool is_free = joint.position > of.low + kAtStop && joint.position < of.high - kAtStop;
    if (!(servo.max_torque > 0.0) || !(strength > 0.0) || !is_free || !joint.is_firm(slope)) {
      if (holds()) release(id, of, joint.cfm);
      return false;
    }
    slope_ = slope;
    strength_ = strength;
    damping_ = of.damping;
    most_ = strength * servo.max_torque;
    target_ = strength * servo.stiffness * (servo.position - joint.position) / slope;
    set(id, of, target_, 1.0 / slope,
        most_ + of.friction + of.damping * eagerx::abs(joint.velocity));
    return true;
  }

  /// Of the servo at full strength, after the step.
  constexpr double torque_at(double velocity) const {
    const double wanted = slope_ * (target_ - velocity) + damping_ * velocity;
    return eagerx::max(-most_, eagerx::min(wanted, most_)) / strength_;
  }

 private:
  static constexpr double kAtStop = 1e-6;  // [rad, m]

  void release(dJointID id, const RigidJoint& of, double cfm) {
    *this = {};
    set(id, of, 0.0, cfm, of.friction);
  }
  static void set(dJointID id, const RigidJoint& of, double velocity, double cfm, double most) {
    set_joint_parameter(id, of.kind, dParamVel, velocity);
    set_joint_parameter(id, of.kind, dParamCFM, cfm);
    set_joint_parameter(id, of.kind, dParamFMax, most);
  }

  double slope_ = 0.0, target_ = 0.0;  // the torque is slope·(target − velocity)
  double damping_ = 0.0;               // of the joint, which is part of the slope
  double most_ = 0.0, strength_ = 1.0;
};

}  // namespace eagerx::models

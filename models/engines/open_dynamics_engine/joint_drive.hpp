// What moves one joint on OpenDynamicsEngine: a torque, a motor or a servo, next to its damping.
#pragma once

#include <ode/ode.h>

#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/rigid_parts.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <models/engines/open_dynamics_engine/servo_constraint.hpp>
#include <models/engines/open_dynamics_engine/spring_constraint.hpp>

namespace eagerx::models {

/// Torques are those of a hinge about its axis [N·m], or forces of a slider [N], and never more
/// than the joint's max_torque. What is set stays until it is set again.
class JointDrive {
 public:
  /// Without torque and servo, at full strength.
  void restart() {
    torque_ = 0.0;
    servo_ = {};
    factors_ = {1.0, 1.0, 1.0};
  }
  /// Factors on torques and gains; negative or non-finite ones are ignored.
  void set_strength(double factor) {
    if (is_factor(factor)) factors_.strength = factor;
  }
  void set_gains(double stiffness, double damping) {
    if (is_factor(stiffness)) factors_.stiffness = stiffness;
    if (is_factor(damping)) factors_.damping = damping;
  }

  /// Instead of torques.
  void set_servo(const RigidJoint& of, JointServo servo) {
    servo.position = finite_or_zero(servo.position);
    servo.max_torque = eagerx::min(servo.max_torque, of.max_torque);
    servo_ = servo;
  }
  void set_torque(const RigidJoint& of, double torque) {
    torque_ = eagerx::max(-of.max_torque, eagerx::min(finite_or_zero(torque), of.max_torque));
  }
  double torque() const { return torque_ * factors_.strength; }
  /// Makes the joint move at `velocity` with `torque` at most. A motor that is not stronger than
  /// the joint's friction does nothing.
  void set_motor(dJointID id, const RigidJoint& of, double velocity, double torque) {
    const double most =
        eagerx::min(finite_or_zero(torque), of.max_torque) * factors_.strength - of.friction;
    has_motor_ = most > 0.0;
    set_joint_parameter(id, of.kind, dParamVel, has_motor_ ? finite_or_zero(velocity) : 0.0);
    set_joint_parameter(id, of.kind, dParamFMax, has_motor_ ? most : of.friction);
  }

  /// The torque to apply in a step; 0 if a motor of the library applies it.
  double torque_of_step(dJointID id, const RigidJoint& joint, const JointStep& at) {
    const RigidJoint of = SpringConstraint::without(joint);
    const JointServo servo = scaled(servo_, factors_);
    if (degrees_of_freedom(of.kind) == 1 &&
        constraint_.hold(id, of, has_motor_ ? JointServo{} : servo, factors_.strength, at))
      return 0.0;
    if (servo.max_torque > 0.0) torque_ = servo_torque(servo, at);
    return torque() - damping_torque(id, of, at, torque());
  }
  /// Whether a motor of the library applies the servo's torque: after_step() then notes it.
  bool is_constraint() const { return constraint_.holds(); }
  /// `velocity` is that after the step.
  void after_step(double velocity) { torque_ = constraint_.torque_at(velocity); }

 private:
  /// As a motor that holds 0, which never turns the joint around, with the torque of the velocity
  /// at the end of the step. A joint has one motor, so next to another it is a torque.
  double damping_torque(dJointID id, const RigidJoint& of, const JointStep& at,
                        double applied) const {
    if (!(of.damping > 0.0)) return 0.0;
    // A torque of the step's beginning must not turn the joint around.
    if (has_motor_ && !at.is_firm(of.damping)) return of.damping * at.velocity;
    const double v = velocity_after(of, at.inertia, at.velocity, applied, at.step_s);
    if (has_motor_) return of.damping * v;
    set_joint_parameter(id, of.kind, dParamFMax, of.friction + of.damping * eagerx::abs(v));
    return 0.0;
  }

  double torque_ = 0.0;
  JointServo servo_{};
  ActuatorFactors factors_{};
  bool has_motor_ = false;
  ServoConstraint constraint_{};
};

}  // namespace eagerx::models

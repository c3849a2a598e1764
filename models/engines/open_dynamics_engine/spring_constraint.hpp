// Springs that are stable at every step.
//
// A spring with the damping of its joint is a motor of the library with a softness (CFM), which
// makes it the torque at the end of the step, where the joint is at q + dt·v':
//   torque = stiffness·(rest − q − dt·v') − damping·v' = slope·(target − v').
// With ERP = dt·stiffness/slope and CFM = 1/slope, this is the spring and damper of the library's
// manual. The spring has a separate motor, so that the joint's motor stays free for actuators and
// friction.
#pragma once

#include <ode/ode.h>

#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// All zero where the joint has no spring.
class SpringConstraint {
 public:
  static constexpr bool is_on(const RigidJoint& of) {
    return of.stiffness > 0.0 && degrees_of_freedom(of.kind) == 1;
  }
  /// The joint without the torques that the spring's motor applies.
  static constexpr RigidJoint without(RigidJoint of) {
    if (is_on(of)) of.damping = 0.0;
    return of;
  }

  void create(dWorldID world, const RigidJoint& of, dBodyID child, dBodyID parent) {
    if (!is_on(of)) return;
    turns_ = of.kind == JointKind::hinge;
    motor_ = turns_ ? dJointCreateAMotor(world, nullptr) : dJointCreateLMotor(world, nullptr);
    dJointAttach(motor_, child, parent);
    if (turns_) {
      dJointSetAMotorNumAxes(motor_, 1);
    } else {
      dJointSetLMotorNumAxes(motor_, 1);
    }
    set(dParamFMax, dInfinity);
  }
  /// The child has to be in the reference pose.
  void anchor(const RigidJoint& of) {
    if (motor_ == nullptr) return;
    constexpr int kAxisOfChild = 1;
    const Vector3& axis = of.axis;
    if (turns_) {
      dJointSetAMotorAxis(motor_, 0, kAxisOfChild, axis[0], axis[1], axis[2]);
    } else {
      dJointSetLMotorAxis(motor_, 0, kAxisOfChild, axis[0], axis[1], axis[2]);
    }
  }
  /// Before each step.
  void pull(const RigidJoint& of, double position, double step_s) {
    if (motor_ == nullptr) return;
    const double slope = of.damping + step_s * of.stiffness;
    set(dParamVel, of.stiffness * (of.rest - position) / slope);
    set(dParamCFM, 1.0 / slope);
  }

 private:
  void set(int parameter, double value) {
    if (turns_) {
      dJointSetAMotorParam(motor_, parameter, value);
    } else {
      dJointSetLMotorParam(motor_, parameter, value);
    }
  }

  dJointID motor_ = nullptr;
  bool turns_ = false;
};

}  // namespace eagerx::models

// Which engines can simulate a robot, and which of its joints is the quickest.
#include <algorithm>
#include <cmath>

#include "generator/urdf/robot.hpp"
#include "models/engines/open_dynamics_engine/rigid_joints.hpp"

namespace eagerx::urdf {

bool can_use_multibody(const Robot& robot) {
  const auto planes = std::ranges::count(robot.shapes, models::ShapeKind::plane, &Shape::kind);
  if (planes + (robot.ground ? 1 : 0) > 1) return false;
  const auto free = std::ranges::count_if(robot.bodies, &Body::is_free);
  const bool on_world = std::ranges::any_of(
      robot.joints, [](const BodyJoint& joint) { return joint.parent.empty(); });
  return free + (on_world ? 1 : 0) == 1;
}

bool can_use_open_dynamics(const Robot& robot) {
  return std::ranges::all_of(robot.joints, &std::string::empty, &BodyJoint::mimics);
}

std::optional<QuickJoint> quickest_joint(const Robot& robot) {
  std::optional<QuickJoint> result;
  for (const BodyJoint& joint : robot.joints) {
    const double speed = joint.limits.velocity, torque = joint.limits.effort;
    if (joint.is_fixed || !std::isfinite(speed) || !std::isfinite(torque) || torque <= 0.0)
      continue;
    const auto child = std::ranges::find(robot.bodies, joint.child, &Body::name);
    models::RigidJoint as_scene;
    as_scene.kind = joint.slides ? models::JointKind::slider : models::JointKind::hinge;
    as_scene.anchor = joint.anchor;
    as_scene.axis = joint.axis;
    const models::RigidBody body = {.name = "",
                                    .mass = child->mass,
                                    .inertia = child->inertia,
                                    .position = child->position,
                                    .products = child->products};
    const double time_s = models::inertia_of_joint(as_scene, body) * speed / torque;
    if (!result || time_s < result->time_s) result = QuickJoint{joint.name, time_s, speed};
  }
  return result;
}

}  // namespace eagerx::urdf

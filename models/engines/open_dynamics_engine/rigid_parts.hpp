// Joints and geometries of a scene, made with the Open Dynamics Engine.
#pragma once

#include <ode/ode.h>

#include <limits>
#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Hinges and sliders only; the others have no motors and stops here.
inline void set_joint_parameter(dJointID joint, JointKind kind, int parameter, double value) {
  if (kind == JointKind::hinge) dJointSetHingeParam(joint, parameter, value);
  if (kind == JointKind::slider) dJointSetSliderParam(joint, parameter, value);
}

/// The library measures angles of hinges within half a turn, so that a stop near or beyond that
/// does not hold. Such stops are switched on only where the joint, whose turns are counted, is near
/// them, and the angle is measured from where both are far from half a turn.
struct HingeStops {
  static constexpr double kPi = 3.141592653589793;
  static constexpr double kFar = kPi - 0.3;  // what the library is left alone with [rad]
  static constexpr double kNear = 1.0;       // where a stop is switched on [rad]

  static constexpr bool is_finite(double stop) {
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    return stop > -kUnlimited && stop < kUnlimited;
  }
  static constexpr bool are_switched(const RigidJoint& joint) {
    const auto is_far = [](double stop) {
      return is_finite(stop) && (stop > kFar || stop < -kFar);
    };
    return joint.kind == JointKind::hinge && (is_far(joint.low) || is_far(joint.high));
  }
  /// Within half a turn.
  static constexpr double wrapped(double angle) {
    return angle - 2.0 * kPi * eagerx::floor(angle / (2.0 * kPi) + 0.5);
  }
  /// Where the library's angle is 0, of the joint's position: between the stops, the short way.
  static constexpr double middle(const RigidJoint& joint) {
    if (!is_finite(joint.low)) return joint.high;
    if (!is_finite(joint.high)) return joint.low;
    return joint.low + 0.5 * wrapped(joint.high - joint.low);
  }
  static void update(dJointID id, const RigidJoint& joint, double position) {
    const double zero = middle(joint);
    const bool low = position - joint.low < kNear, high = joint.high - position < kNear;
    dJointSetHingeParam(id, dParamLoStop, low ? wrapped(joint.low - zero) : -dInfinity);
    dJointSetHingeParam(id, dParamHiStop, high ? wrapped(joint.high - zero) : dInfinity);
  }
};

inline dJointID create_joint(dWorldID world, JointKind kind) {
  switch (kind) {
    case JointKind::hinge:
      return dJointCreateHinge(world, nullptr);
    case JointKind::slider:
      return dJointCreateSlider(world, nullptr);
    case JointKind::universal:
      return dJointCreateUniversal(world, nullptr);
    case JointKind::ball:
      return dJointCreateBall(world, nullptr);
    case JointKind::fixed:
      break;
  }
  return dJointCreateFixed(world, nullptr);
}

/// A joint without a place, see anchor_joint(). The library's first body is the child, so that its
/// motors turn as the scene says; `parent` is null for the world.
inline dJointID create_joint(dWorldID world, const RigidJoint& joint, dBodyID child,
                             dBodyID parent) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  const dJointID result = create_joint(world, joint.kind);
  dJointAttach(result, child, parent);
  if (joint.friction > 0.0)
    set_joint_parameter(result, joint.kind, dParamFMax, joint.friction);  // at velocity 0
  if (HingeStops::are_switched(joint)) return result;
  if (joint.low > -kUnlimited) set_joint_parameter(result, joint.kind, dParamLoStop, joint.low);
  if (joint.high < kUnlimited) set_joint_parameter(result, joint.kind, dParamHiStop, joint.high);
  return result;
}

/// The library takes one axis after the other and wants them never to be parallel in between.
inline void set_universal_axes(dJointID joint, const Vector3& first, const Vector3& second) {
  const Vector3 between = first + 0.5 * second + 0.25 * cross(first, second);
  dJointSetUniversalAxis1(joint, between[0], between[1], between[2]);
  dJointSetUniversalAxis2(joint, second[0], second[1], second[2]);
  dJointSetUniversalAxis1(joint, first[0], first[1], first[2]);
}

/// Fixes anchor and axes to the bodies, which have to be in the reference pose.
inline void anchor_joint(dJointID id, const RigidJoint& joint, const Vector3& at) {
  const Vector3& axis = joint.axis;
  switch (joint.kind) {
    case JointKind::hinge:
      dJointSetHingeAnchor(id, at[0], at[1], at[2]);
      if (HingeStops::are_switched(joint)) {
        dJointSetHingeAxisOffset(id, axis[0], axis[1], axis[2], -HingeStops::middle(joint));
      } else {
        dJointSetHingeAxis(id, axis[0], axis[1], axis[2]);
      }
      break;
    case JointKind::slider:
      dJointSetSliderAxis(id, axis[0], axis[1], axis[2]);
      break;
    case JointKind::universal:
      dJointSetUniversalAnchor(id, at[0], at[1], at[2]);
      set_universal_axes(id, joint.axis2, axis);  // the child, which comes first, has axis2
      break;
    case JointKind::ball:
      dJointSetBallAnchor(id, at[0], at[1], at[2]);
      break;
    case JointKind::fixed:
      dJointSetFixed(id);
      break;
  }
}

inline dGeomID create_geometry(dSpaceID space, const RigidGeometry& geometry,
                               const Vector3& origin) {
  const Vector3& size = geometry.size;
  switch (geometry.kind) {
    case ShapeKind::sphere:
      return dCreateSphere(space, size[0]);
    case ShapeKind::box:
      return dCreateBox(space, size[0], size[1], size[2]);
    case ShapeKind::capsule:
      return dCreateCapsule(space, size[0], size[1]);
    case ShapeKind::cylinder:
      return dCreateCylinder(space, size[0], size[1]);
    case ShapeKind::plane:
      break;
  }
  const Vector3& n = geometry.axis;
  return dCreatePlane(space, n[0], n[1], n[2], dot(n, origin + geometry.position));
}

/// In its place on the body, or in the object's frame if `body` is null.
inline dGeomID create_geometry(dSpaceID space, const RigidGeometry& geometry, dBodyID body,
                               const Vector3& origin) {
  const dGeomID geom = create_geometry(space, geometry, origin);
  if (geometry.kind == ShapeKind::plane) return geom;
  const Quaternion& turn = geometry.rotation;
  const bool is_turned = turn != kNoRotation;
  const dQuaternion q = {turn[0], turn[1], turn[2], turn[3]};
  if (body != nullptr) {
    const Vector3& at = geometry.position;
    dGeomSetBody(geom, body);
    dGeomSetOffsetPosition(geom, at[0], at[1], at[2]);
    if (is_turned) dGeomSetOffsetQuaternion(geom, q);
  } else {
    const Vector3 at = origin + geometry.position;
    dGeomSetPosition(geom, at[0], at[1], at[2]);
    if (is_turned) dGeomSetQuaternion(geom, q);
  }
  return geom;
}

inline RigidState state_of(dBodyID body) {
  const dReal* p = dBodyGetPosition(body);
  const dReal* q = dBodyGetQuaternion(body);
  const dReal* v = dBodyGetLinearVel(body);
  const dReal* w = dBodyGetAngularVel(body);
  return {
      {{p[0], p[1], p[2]}}, {{q[0], q[1], q[2], q[3]}}, {{v[0], v[1], v[2]}}, {{w[0], w[1], w[2]}}};
}
/// Without a force.
inline void place_body(dBodyID body, const RigidState& to) {
  const dQuaternion q = {to.rotation[0], to.rotation[1], to.rotation[2], to.rotation[3]};
  dBodySetPosition(body, to.position[0], to.position[1], to.position[2]);
  dBodySetQuaternion(body, q);
  dBodySetLinearVel(body, to.velocity[0], to.velocity[1], to.velocity[2]);
  const Vector3& w = to.angular_velocity;
  dBodySetAngularVel(body, w[0], w[1], w[2]);
  dBodySetForce(body, 0, 0, 0);
  dBodySetTorque(body, 0, 0, 0);
}

/// The torque of a hinge or the force of a slider on the child, and its opposite on the parent, if
/// that is not the world.
inline void push_apart(JointKind kind, const Vector3& t, dBodyID child, dBodyID parent) {
  if (kind == JointKind::hinge) {
    dBodyAddTorque(child, t[0], t[1], t[2]);
    if (parent != nullptr) dBodyAddTorque(parent, -t[0], -t[1], -t[2]);
  } else if (kind == JointKind::slider) {
    const dReal* at = dBodyGetPosition(child);
    dBodyAddForce(child, t[0], t[1], t[2]);
    if (parent != nullptr) dBodyAddForceAtPos(parent, -t[0], -t[1], -t[2], at[0], at[1], at[2]);
  }
}

}  // namespace eagerx::models

// Joints and geometries of a scene, made with the Open Dynamics Engine.
#pragma once

#include <ode/ode.h>

#include <limits>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Hinges and sliders only; the others have no motors and stops here.
inline void set_joint_parameter(dJointID joint, JointKind kind, int parameter, double value) {
  if (kind == JointKind::hinge) dJointSetHingeParam(joint, parameter, value);
  if (kind == JointKind::slider) dJointSetSliderParam(joint, parameter, value);
}

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
  if (joint.low > -kUnlimited) set_joint_parameter(result, joint.kind, dParamLoStop, joint.low);
  if (joint.high < kUnlimited) set_joint_parameter(result, joint.kind, dParamHiStop, joint.high);
  if (joint.friction > 0.0)
    set_joint_parameter(result, joint.kind, dParamFMax, joint.friction);  // at velocity 0
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
      dJointSetHingeAxis(id, axis[0], axis[1], axis[2]);
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

}  // namespace eagerx::models

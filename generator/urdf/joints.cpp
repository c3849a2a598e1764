// Converts joints with several axes into chains of hinges and sliders.
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "generator/urdf/urdf.hpp"

namespace eagerx::urdf {
namespace {

/// One axis of a joint, and what its name ends with.
struct Axis {
  JointType type;
  Vector3 direction;
  const char* suffix;
};
using Axes = std::array<Axis, 3>;

/// Two directions in the plane of this normal.
std::pair<Vector3, Vector3> in_plane(const Vector3& normal) {
  const Vector3 other =
      std::abs(normal[0]) < 0.9 ? Vector3{{1.0, 0.0, 0.0}} : Vector3{{0.0, 1.0, 0.0}};
  const Vector3 apart = other - dot(other, normal) * normal;
  const Vector3 first = (1.0 / std::sqrt(dot(apart, apart))) * apart;
  return {first, models::cross(normal, first)};
}

Axes axes_of(const Joint& joint) {
  if (joint.type == JointType::spherical)
    return {{{JointType::continuous, {{1.0, 0.0, 0.0}}, "_x"},
             {JointType::continuous, {{0.0, 1.0, 0.0}}, "_y"},
             {JointType::continuous, {{0.0, 0.0, 1.0}}, "_z"}}};
  const auto [first, second] = in_plane(joint.axis);
  return {{{JointType::prismatic, first, "_x"},
           {JointType::prismatic, second, "_y"},
           {JointType::continuous, joint.axis, "_turn"}}};
}

}  // namespace

void set_base(Description& description, bool is_free) {
  if (!description.has_world) return;
  for (Joint& joint : description.joints) {
    if (joint.parent != description.links[0].name) continue;
    if (is_free && joint.type == JointType::fixed) joint.type = JointType::floating;
    if (!is_free && joint.type == JointType::floating) joint.type = JointType::fixed;
  }
}

void expand_joints(Description& description) {
  std::vector<Joint> joints;
  for (Joint& joint : description.joints) {
    if (joint.type != JointType::planar && joint.type != JointType::spherical) {
      joints.push_back(std::move(joint));
      continue;
    }
    std::string parent = joint.parent;
    const Axes axes = axes_of(joint);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      Joint one = joint;
      one.name += axes[i].suffix;
      one.type = axes[i].type;
      one.axis = axes[i].direction;
      one.parent = parent;
      if (i > 0) one.origin = {};
      if (i + 1 < axes.size()) {
        one.child = one.name;
        Link made;
        made.name = one.name;
        made.place = joint.place;
        made.is_made = true;
        if (description.has_world) made.share = kSmallShare;
        description.links.push_back(std::move(made));
      }
      parent = one.child;
      joints.push_back(std::move(one));
    }
  }
  description.joints = std::move(joints);
}

}  // namespace eagerx::urdf

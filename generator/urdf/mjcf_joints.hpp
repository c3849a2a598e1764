// Joints and actuators of MJCF.
#pragma once

#include "generator/urdf/mjcf_frames.hpp"

namespace eagerx::urdf {

/// A joint as its element says, but for its place in the tree.
struct JointElement {
  Joint joint;             // `axis`, limits, spring; `reference` is not applied
  Vector3 position{};      // in the body's frame
  double reference = 0.0;  // what its position is as the description draws it
};
JointElement read_joint(const Element& element, const Compiler& compiler);

/// `equality`: joints that follow others. Whatever else holds is an error.
void read_equalities(Document& document, Description& description);

/// `actuator`: which joints have some, with which gains and limits. Without any, all joints have.
void read_actuators(Document& document, Description& description);

}  // namespace eagerx::urdf

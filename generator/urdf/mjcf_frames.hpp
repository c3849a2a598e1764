// Angles, frames and inertia, interpreted as the element `compiler` says.
#pragma once

#include <optional>
#include <string>

#include "generator/urdf/mjcf_document.hpp"

namespace eagerx::urdf {

/// `compiler` of MJCF.
struct Compiler {
  double angle = 0.017453292519943295;  // [rad] of the unit of angles
  std::string euler = "xyz";            // axes, those that turn along in lower case
  bool autolimits = true;
  std::string mesh_folder;  // with a slash at its end
  bool strips_paths = false;
  std::optional<bool> inertia_from_geoms;      // always, never; only where there is no `inertial`
  double first_group = 0.0, last_group = 5.0;  // of geoms that have inertia
  double least_mass = 0.0, least_inertia = 0.0;
  bool balances_inertia = false;
  double total_mass = -1.0;  // [kg], if positive
};
Compiler read_compiler(Document& document);

/// `pos` and one of `quat`, `axisangle`, `euler`, `xyaxes`, `zaxis`.
Frame frame_of(const Element& element, const Compiler& compiler);
/// The rotation that turns z into this direction, by the shortest way.
Quaternion rotation_to(const Vector3& direction);

}  // namespace eagerx::urdf

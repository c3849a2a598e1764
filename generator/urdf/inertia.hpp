// Inertia of links, turned and put together.
#pragma once

#include <vector>

#include "generator/urdf/urdf.hpp"

namespace eagerx::urdf {

/// About the centre of mass, along the axes of the robot's frame.
struct MassAndInertia {
  double mass = 0.0;   // [kg]
  Vector3 centre{};    // [m]
  Vector3 inertia{};   // Ixx, Iyy, Izz [kg·m²]
  Vector3 products{};  // Ixy, Ixz, Iyz
};

/// The inertia of a link in this frame.
MassAndInertia turned(const Inertial& inertial, const Frame& link);
/// One body of all parts, by the theorem of Steiner.
MassAndInertia together(const std::vector<MassAndInertia>& parts);

/// The inertia of a ball of water of this mass about each axis [kg·m²].
double ball_of_water(double mass);

/// Whether every axis has a positive inertia.
bool is_positive(const Vector3& inertia, const Vector3& products);
/// Whether, in addition, none exceeds the sum of the other two principal moments, except for
/// rounding.
bool is_of_a_body(const Vector3& inertia, const Vector3& products);

}  // namespace eagerx::urdf

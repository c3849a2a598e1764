// Contacts of shapes with a height field. Contacts are those of MultibodyEngine: points of a shape
// and the plane tangent to the ground below each. The library's own height field misses a small
// ball on a ridge, and allocates memory during steps.
#pragma once

#include <ode/ode.h>

#include <cstddef>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Heights of a model's plane, in the world.
struct RigidHeights {
  double (*height)(std::size_t i, std::size_t k) = nullptr;  // of the grid; null: level
  std::size_t points[2] = {2, 2};
  double corner[2] = {0.0, 0.0}, level = 0.0, spacing = 1.0;  // [m]
  double roughness = 1.0;                                     // factor of the heights

  template <class Model>
  static constexpr RigidHeights of(const Vector3& origin, const RigidGeometry& plane) {
    constexpr auto& kField = Model::kHeights;
    return {.height = [](std::size_t i,
                         std::size_t k) { return static_cast<double>(kField.height[i][k]); },
            .points = {kField.kX, kField.kY},
            .corner = {origin[0] + kField.corner[0], origin[1] + kField.corner[1]},
            .level = origin[2] + plane.position[2],
            .spacing = kField.spacing};
  }

  /// The plane tangent to the ground above or below a point.
  struct Plane {
    Vector3 at, normal;
  };
  [[nodiscard]] Plane below(const Vector3& point) const {
    const double x = in_cells(point, 0), y = in_cells(point, 1);
    const std::size_t i = cell(x, points[0]), k = cell(y, points[1]);
    const double u = x - static_cast<double>(i), v = y - static_cast<double>(k);
    const double corners[2][2] = {{height(i, k), height(i, k + 1)},
                                  {height(i + 1, k), height(i + 1, k + 1)}};
    const double low = corners[0][0] + (corners[0][1] - corners[0][0]) * v;
    const double high = corners[1][0] + (corners[1][1] - corners[1][0]) * v;
    const double per = roughness / spacing, along_x = (high - low) * per;
    const double along_y =
        ((corners[0][1] - corners[0][0]) * (1.0 - u) + (corners[1][1] - corners[1][0]) * u) * per;
    const double scale = 1.0 / eagerx::sqrt(1.0 + along_x * along_x + along_y * along_y);
    return {{{point[0], point[1], level + (low + (high - low) * u) * roughness}},
            {{-along_x * scale, -along_y * scale, scale}}};
  }

 private:
  /// Points outside the grid are moved to its edge, and NaN to the corner.
  [[nodiscard]] double in_cells(const Vector3& point, std::size_t axis) const {
    const double cells = (point[axis] - corner[axis]) / spacing;
    const auto most = static_cast<double>(points[axis] - 1);
    if (!(cells > 0.0)) return 0.0;
    return cells < most ? cells : most;
  }
  [[nodiscard]] static std::size_t cell(double x, std::size_t points) {
    const auto i = static_cast<std::size_t>(x);
    return i < points - 2 ? i : points - 2;
  }
};

/// Where a shape may touch the ground.
class GroundPoints {
 public:
  static constexpr std::size_t kMost = 8;

  explicit GroundPoints(dGeomID geom) : kind_(dGeomGetClass(geom)) {
    const dReal* at = dGeomGetPosition(geom);
    const dReal* turn = dGeomGetRotation(geom);
    center_ = {{at[0], at[1], at[2]}};
    for (std::size_t c = 0; c < 3; ++c) axis_[c] = {{turn[c], turn[4 + c], turn[8 + c]}};
    if (kind_ == dSphereClass) radius_ = dGeomSphereGetRadius(geom);
    if (kind_ == dCapsuleClass) dGeomCapsuleGetParams(geom, &radius_, &sides_[2]);
    if (kind_ == dCylinderClass) dGeomCylinderGetParams(geom, &rim_, &sides_[2]);
    if (kind_ == dBoxClass) dGeomBoxGetLengths(geom, sides_);
  }

  [[nodiscard]] std::size_t count() const {
    if (kind_ == dSphereClass) return 1;
    if (kind_ == dCapsuleClass) return 2;
    return kind_ == dCylinderClass ? 6 : kind_ == dBoxClass ? kMost : 0;
  }
  /// Position, normal and depth of point `i`; a depth below 0 is above the ground.
  [[nodiscard]] dContactGeom touch(std::size_t i, const RigidHeights& ground) const {
    Vector3 at = center(i);
    RigidHeights::Plane plane = ground.below(at);
    at = at - radius_ * plane.normal;
    if (kind_ == dCylinderClass) {
      at = at + on_rim(i, plane.normal);
      plane = ground.below(at);
    }
    dContactGeom result{};
    for (std::size_t c = 0; c < 3; ++c) result.pos[c] = at[c], result.normal[c] = plane.normal[c];
    result.depth = -dot(plane.normal, at - plane.at);
    return result;
  }

 private:
  [[nodiscard]] Vector3 center(std::size_t i) const {
    const auto half = [](std::size_t bit) { return (bit & 1U) != 0 ? 0.5 : -0.5; };
    if (kind_ == dBoxClass)
      return center_ + half(i) * sides_[0] * axis_[0] + half(i >> 1U) * sides_[1] * axis_[1] +
             half(i >> 2U) * sides_[2] * axis_[2];
    return center_ + half(kind_ == dCylinderClass ? i / 3 : i) * sides_[2] * axis_[2];
  }
  /// Three points of each rim: the lowest, then a third and two thirds of a turn on. A rim that
  /// lies flat begins with a direction of the body.
  [[nodiscard]] Vector3 on_rim(std::size_t i, const Vector3& normal) const {
    constexpr double kFlat = 1e-4, kCosine = -0.5, kSine = 0.8660254037844386;
    const Vector3& axis = axis_[2];
    const double up = dot(axis, normal), square = 1.0 - up * up;
    const Vector3 first =
        square < kFlat ? axis_[0] : (1.0 / eagerx::sqrt(square)) * (up * axis - normal);
    if (i % 3 == 0) return rim_ * first;
    return rim_ * (kCosine * first + (i % 3 == 1 ? kSine : -kSine) * cross(axis, first));
  }

  int kind_;
  Vector3 center_{}, axis_[3] = {};
  dReal radius_ = 0.0, rim_ = 0.0;
  dVector3 sides_ = {};
};

}  // namespace eagerx::models

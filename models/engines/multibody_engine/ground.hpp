// Ground that is not a level plane: tilted planes and height fields. Each contact then has its own
// axes: two along the ground, and its normal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/simd.hpp>
#include <models/engines/multibody_engine/contact.hpp>
#include <models/engines/multibody_engine/kinematics.hpp>
#include <models/engines/multibody_engine/spatial.hpp>
#include <models/engines/multibody_engine/state.hpp>
#include <models/engines/multibody_engine/tree.hpp>

namespace eagerx::models::multibody {

template <class Model>
inline constexpr bool kHasHeights = requires {
  Model::kHeights;
};

/// Normal of the object's plane.
template <class Model>
constexpr Vector3 plane_normal() {
  constexpr std::size_t kPlane = find_plane<Model>();
  if constexpr (kPlane < Model::kGeometries.size()) return Model::kGeometries[kPlane].axis;
  return {{0.0, 0.0, 1.0}};
}
/// A point of the object's plane in the world.
template <class Model>
constexpr Vector3 plane_point() {
  Vector3 at{};
  if constexpr (requires { Model::kOrigin; }) at = Model::kOrigin;
  constexpr std::size_t kPlane = find_plane<Model>();
  if constexpr (kPlane < Model::kGeometries.size()) at = at + Model::kGeometries[kPlane].position;
  return at;
}
/// Whether contacts have the axes of the world.
template <class Model>
inline constexpr bool kIsLevel = plane_normal<Model>()[2] == 1.0 && !kHasHeights<Model>;

/// The columns of a frame with the normal n; n.z or n.x is not 0.
template <class Real>
[[gnu::always_inline]] inline Mat<Real> frame_of(const Vec<Real>& n) {
  const Real zero(LaneOf<Real>(0)), one(LaneOf<Real>(1));
  const Real scale = one / eagerx::sqrt(n.x * n.x + n.z * n.z);
  const Vec<Real> along{n.z * scale, zero, -(n.x * scale)};
  return {{along, cross(n, along), n}};
}

template <class Model>
class Ground {
 public:
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  using Points = PointTable<Model>;

  /// Of point `p` on a link with these axes, whose joint is at `joint` from plane_point().
  [[gnu::always_inline]] static Touch<Real> touch(const State<Model>& state, std::size_t p,
                                                  const Mat<Real>& axes, const Vec<Real>& joint) {
    const auto& entry = Points::kEntries[p];
    Touch<Real> result;
    result.center = axes * Points::vector(entry.place);
    Surface below = surface(state, joint + result.center);
    result.at = result.center - below.normal * Real(entry.radius);
    if constexpr (Points::kHasRims) {
      if (entry.rim != Lane(0)) {  // the same in all lanes
        result.at = result.at + Points::on_rim(entry, axes, below.normal);
        if constexpr (kHasHeights<Model>) below = surface(state, joint + result.at);
      }
    }
    result.frame = frame_of(below.normal);
    result.depth = -dot(below.normal, joint + result.at - below.point);
    return result;
  }

  /// Of a point from plane_point() [m]: vertical above heights, else the distance from the plane.
  static Real height(const State<Model>& state, const Vec<Real>& at) {
    const Surface below = surface(state, at);
    if constexpr (kHasHeights<Model>) return at.z - below.point.z;
    return dot(below.normal, at);
  }

 private:
  struct Surface {
    Vec<Real> point, normal;
  };

  [[gnu::always_inline]] static Surface surface(const State<Model>& state, const Vec<Real>& at) {
    if constexpr (kHasHeights<Model>) {
      return heights(state, at);
    } else {
      static_cast<void>(state), static_cast<void>(at);
      return {all(Real(Lane(0))), constant<Real>(plane_normal<Model>())};
    }
  }

  /// The tangential plane above or below a point.
  static Surface heights(const State<Model>& state, const Vec<Real>& at) {
    constexpr auto& kField = Model::kHeights;
    constexpr Vector3 kFrom = [] {
      Vector3 origin{};
      if constexpr (requires { Model::kOrigin; }) origin = Model::kOrigin;
      return origin + Vector3{{kField.corner[0], kField.corner[1], 0.0}} - plane_point<Model>();
    }();
    const Real per(static_cast<Lane>(1.0 / kField.spacing)), one(Lane(1));
    const Real x = within(at.x - Real(static_cast<Lane>(kFrom[0])), per, kField.kX);
    const Real y = within(at.y - Real(static_cast<Lane>(kFrom[1])), per, kField.kY);
    const Real i = cell(x, kField.kX), k = cell(y, kField.kY);
    Real corner[4];
    for (int l = 0; l < lanes<Real>; ++l) {
      const auto row = static_cast<std::size_t>(lane(i, l));
      const auto column = static_cast<std::size_t>(lane(k, l));
      for (std::size_t c = 0; c < 4; ++c)
        set_lane(corner[c], l, static_cast<Lane>(kField.height[row + c / 2][column + c % 2]));
    }
    const Real u = x - i, v = y - k;
    const Real low = corner[0] + (corner[1] - corner[0]) * v;
    const Real high = corner[2] + (corner[3] - corner[2]) * v;
    const Real height = (low + (high - low) * u) * state.roughness;
    const Real along_x = (high - low) * per * state.roughness;
    const Real along_y =
        ((corner[1] - corner[0]) * (one - u) + (corner[3] - corner[2]) * u) * per * state.roughness;
    const Real scale = one / eagerx::sqrt(one + along_x * along_x + along_y * along_y);
    return {{at.x, at.y, height}, {-(along_x * scale), -(along_y * scale), scale}};
  }
  /// In cells from the corner; non-finite values become 0.
  [[gnu::always_inline]] static Real within(const Real& x, const Real& per, std::size_t points) {
    const Real zero(Lane(0)), most(static_cast<Lane>(points - 1));
    const Real cells = x * per;
    return eagerx::select(eagerx::isfinite(cells), eagerx::max(zero, eagerx::min(cells, most)),
                          zero);
  }
  [[gnu::always_inline]] static Real cell(const Real& x, std::size_t points) {
    return eagerx::min(eagerx::floor(x), Real(static_cast<Lane>(points - 2)));
  }
};

}  // namespace eagerx::models::multibody

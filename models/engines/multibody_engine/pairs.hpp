// Contacts of chosen pairs of spheres and capsules of one object.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/constants.hpp>
#include <models/engines/multibody_engine/contact.hpp>
#include <models/engines/multibody_engine/kinematics.hpp>
#include <models/engines/multibody_engine/moving.hpp>
#include <models/engines/multibody_engine/spatial.hpp>

namespace eagerx::models::multibody {

/// A sphere, or the middle line of a capsule, on a link or the base.
struct RoundShape {
  std::size_t geometry = 0, link = kNone;
  Vector3 center{}, half{};  // from the link's joint; from the center to an end
  double radius = 0.0;
};
template <class Model>
constexpr RoundShape round_shape(const char* name) {
  RoundShape shape;
  shape.geometry = scene::find(Model::kGeometries, name);
  if (shape.geometry == Model::kGeometries.size()) return shape;
  const RigidGeometry& geometry = Model::kGeometries[shape.geometry];
  const std::size_t body = scene::find(Model::kBodies, geometry.body);
  if (body == Model::kBodies.size()) return shape;
  shape.link = kTree<Model>.link_of_body[body];
  shape.center = kTree<Model>.place_of_body[body] + geometry.position;
  if (geometry.kind == ShapeKind::capsule)
    shape.half = rotate(geometry.rotation, {{0.0, 0.0, 0.5 * geometry.size[1]}});
  shape.radius = geometry.size[0];
  return shape;
}
template <class Model>
inline constexpr auto kPairsOf = [] {
  std::array<std::array<RoundShape, 2>, count_pairs<Model>()> result{};
  if constexpr (count_pairs<Model>() > 0) {
    for (std::size_t i = 0; i < result.size(); ++i) {
      for (std::size_t side = 0; side < 2; ++side)
        result[i][side] = round_shape<Model>(Model::kPairs[i][side]);
    }
  }
  return result;
}();
/// Whether all of them are spheres and capsules of bodies.
template <class Model>
constexpr bool has_round_pairs() {
  for (const auto& pair : kPairsOf<Model>) {
    for (const RoundShape& shape : pair) {
      if (shape.geometry == Model::kGeometries.size()) return false;
      const RigidGeometry& geometry = Model::kGeometries[shape.geometry];
      if (*geometry.body == '\0') return false;
      if (geometry.kind != ShapeKind::sphere && geometry.kind != ShapeKind::capsule) return false;
    }
  }
  return true;
}

/// Distance of the nearest points of two lines from the lines' midpoints, in half lengths: Ericson,
/// Real-Time Collision Detection, 2005, section 5.1.9. `a`, `b` are halves, `between` is the way
/// from the middle of b to that of a.
template <class Real>
inline std::array<Real, 2> nearest(const Vec<Real>& a, const Vec<Real>& b,
                                   const Vec<Real>& between) {
  using Lane = LaneOf<Real>;
  const Real tiny(Lane(1e-12)), one(Lane(1)), zero(Lane(0));
  const Real aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
  const Real along_a = dot(a, between), along_b = dot(b, between);
  const auto within = [&](const Real& x) { return eagerx::max(-one, eagerx::min(x, one)); };
  const Real area = aa * bb - ab * ab;
  const Real s =
      eagerx::select(area > tiny * aa * bb,
                     within((ab * along_b - along_a * bb) / eagerx::max(area, tiny * tiny)), zero);
  const Real t = within((ab * s + along_b) / eagerx::max(bb, tiny));
  return {within((ab * t - along_a) / eagerx::max(aa, tiny)), t};
}

/// A side of a contact: the link, the nearest point of its middle line and the contact, both from
/// the base's reference point.
template <class Real>
struct PairSide {
  Vec<Real> center, at;
};

/// Where two shapes are nearest.
template <class Real>
struct PairTouch {
  PairSide<Real> side[2];
  Mat<Real> frame;  // its third axis is from the second shape to the first
  Real depth;
};

template <class Real>
inline PairTouch<Real> touch_of_pair(const std::array<RoundShape, 2>& pair,
                                     const Moving<Real>* const (&link)[2]) {
  using Lane = LaneOf<Real>;
  const Real zero(Lane(0)), one(Lane(1)), tiny(Lane(1e-9));
  Vec<Real> middle[2], half[2];
  for (std::size_t i = 0; i < 2; ++i) {
    middle[i] = link[i]->at + link[i]->axes * constant<Real>(pair[i].center);
    half[i] = link[i]->axes * constant<Real>(pair[i].half);
  }
  const std::array<Real, 2> where = nearest(half[0], half[1], middle[0] - middle[1]);
  PairTouch<Real> touch;
  for (std::size_t i = 0; i < 2; ++i) touch.side[i].center = middle[i] + half[i] * where[i];
  const Vec<Real> between = touch.side[0].center - touch.side[1].center;
  const Real distance = eagerx::sqrt(dot(between, between));
  const auto apart = distance > tiny;
  const Real scale = one / eagerx::max(distance, tiny);
  const Vec<Real> n{eagerx::select(apart, between.x * scale, zero),
                    eagerx::select(apart, between.y * scale, zero),
                    eagerx::select(apart, between.z * scale, one)};
  // An axis of the world that n is not near.
  const auto upright = eagerx::abs(n.z) > Real(Lane(0.7));
  const Vec<Real> other{eagerx::select(upright, one, zero), zero,
                        eagerx::select(upright, zero, one)};
  const Vec<Real> across = cross(other, n);
  const Vec<Real> first = across * (one / eagerx::sqrt(dot(across, across)));
  touch.frame = {{first, cross(n, first), n}};
  const Real radius[2] = {Real(static_cast<Lane>(pair[0].radius)),
                          Real(static_cast<Lane>(pair[1].radius))};
  touch.side[0].at = touch.side[0].center - n * radius[0];
  touch.side[1].at = touch.side[1].center + n * radius[1];
  touch.depth = radius[0] + radius[1] - distance;
  return touch;
}

}  // namespace eagerx::models::multibody

// Numbers of a robot that are known at compile time: products with 0 and ±1 vanish. Limbs of equal
// shape share code, so a number that differs between them comes from a table.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/spatial.hpp>
#include <models/engines/multibody_engine/tree.hpp>
#include <type_traits>

namespace eagerx::models::multibody {

template <class Model>
inline constexpr auto kTree = tree_of<Model>();

/// Body `part` of those on a link, or on the base.
template <class Model>
constexpr std::size_t body_on(std::size_t link, std::size_t part) {
  for (std::size_t b = 0; b < Model::kBodies.size(); ++b) {
    if (kTree<Model>.link_of_body[b] != link) continue;
    if (part == 0) return b;
    --part;
  }
  return kNone;
}
template <class Model>
constexpr std::size_t bodies_on(std::size_t link) {
  std::size_t count = 0;
  for (const std::size_t other : kTree<Model>.link_of_body) count += other == link ? 1 : 0;
  return count;
}

/// A number of each limb: `Source` has kCount, the number of limbs, and of(limb).
template <class Source, class Lane>
struct Constant {
  static constexpr std::size_t kCount = Source::kCount;
  static constexpr std::array<Lane, kCount> kValues = [] {
    std::array<Lane, kCount> values{};
    for (std::size_t k = 0; k < kCount; ++k) values[k] = static_cast<Lane>(Source::of(k));
    return values;
  }();
  static constexpr bool kUniform = [] {
    for (std::size_t k = 1; k < kCount; ++k) {
      if (kValues[k] != kValues[0]) return false;
    }
    return true;
  }();
  static constexpr bool is(Lane value) { return kUniform && kValues[0] == value; }
};

/// A value that is always zero.
struct Zero {};
[[gnu::always_inline]] inline Zero plus(Zero /*a*/, Zero /*b*/) {
  return {};
}
template <class Real>
requires(!std::is_same_v<Real, Zero>) [[gnu::always_inline]] inline Real
    plus(Zero /*a*/, const Real& b) {
  return b;
}
template <class Real>
requires(!std::is_same_v<Real, Zero>) [[gnu::always_inline]] inline Real
    plus(const Real& a, Zero /*b*/) {
  return a;
}
template <class Real>
requires(!std::is_same_v<Real, Zero>) [[gnu::always_inline]] inline Real
    plus(const Real& a, const Real& b) {
  return a + b;
}

/// The number of limb k.
template <class Real, class Source>
[[gnu::always_inline]] inline Real value(std::size_t k) {
  using Known = Constant<Source, LaneOf<Real>>;
  if constexpr (Known::kUniform) {
    return static_cast<void>(k), Real(Known::kValues[0]);
  } else {
    return Real(Known::kValues[k]);
  }
}
/// Its product with x.
template <class Source, class Real>
[[gnu::always_inline]] inline auto times(std::size_t k, const Real& x) {
  using Lane = LaneOf<Real>;
  using Known = Constant<Source, Lane>;
  if constexpr (Known::is(Lane(0))) {
    return static_cast<void>(k), static_cast<void>(x), Zero{};
  } else if constexpr (Known::is(Lane(1))) {
    return static_cast<void>(k), x;
  } else if constexpr (Known::is(Lane(-1))) {
    return static_cast<void>(k), -x;
  } else {
    return value<Real, Source>(k) * x;
  }
}
template <class Real, class X>
[[gnu::always_inline]] inline Real number(const X& x) {
  if constexpr (std::is_same_v<X, Zero>) {
    return static_cast<void>(x), Real(LaneOf<Real>(0));
  } else {
    return x;
  }
}

/// The vector of three sources, turned by m.
template <class X, class Y, class Z, class Real>
[[gnu::always_inline]] inline Vec<Real> turned_by(std::size_t k, const Mat<Real>& m) {
  const auto row = [k](const Real& a, const Real& b, const Real& c) __attribute__((always_inline)) {
    return number<Real>(plus(plus(times<X>(k, a), times<Y>(k, b)), times<Z>(k, c)));
  };
  return {row(m.column[0].x, m.column[1].x, m.column[2].x),
          row(m.column[0].y, m.column[1].y, m.column[2].y),
          row(m.column[0].z, m.column[1].z, m.column[2].z)};
}

/// m·I·mᵀ of the symmetric matrix of elements 4 to 9 of the source, an InertiaAbout.
template <template <std::size_t> class Source, class Real>
[[gnu::always_inline]] inline Sym<Real> inertia_turned_by(std::size_t k, const Mat<Real>& m) {
  const Vec<Real> x = turned_by<Source<4>, Source<7>, Source<8>>(k, m);
  const Vec<Real> y = turned_by<Source<7>, Source<5>, Source<9>>(k, m);
  const Vec<Real> z = turned_by<Source<8>, Source<9>, Source<6>>(k, m);
  const Vec<Real>&a = m.column[0], &b = m.column[1], &c = m.column[2];
  return {x.x * a.x + y.x * b.x + z.x * c.x, x.y * a.y + y.y * b.y + z.y * c.y,
          x.z * a.z + y.z * b.z + z.z * c.z, x.y * a.x + y.y * b.x + z.y * c.x,
          x.z * a.x + y.z * b.x + z.z * c.x, x.z * a.y + y.z * b.y + z.z * c.y};
}

/// Link j of limb k of group g.
template <class Model, std::size_t g>
struct GroupOf {
  static constexpr Group kGroup = kTree<Model>.groups[g];
  static constexpr std::size_t kCount = kGroup.count;
  static constexpr std::size_t kSize = kGroup.size;
  static constexpr std::size_t kPoints = kGroup.points;

  static constexpr std::size_t index(std::size_t k, std::size_t j) {
    return kGroup.first + k * kSize + j;
  }
  static constexpr const Link& link(std::size_t k, std::size_t j) {
    return kTree<Model>.links[index(k, j)];
  }
  static constexpr const RigidJoint& joint(std::size_t k, std::size_t j) {
    return Model::kJoints[link(k, j).joint];
  }
  /// In a limb; kNone: the base.
  static constexpr std::size_t parent(std::size_t j) {
    return link(0, j).parent == kNone ? kNone : link(0, j).parent - kGroup.first;
  }
  /// Whether i is j, or j hangs on it.
  static constexpr bool carries(std::size_t i, std::size_t j) {
    while (j != i && j != kNone) j = parent(j);
    return j == i;
  }
  static constexpr std::size_t point(std::size_t k, std::size_t p) {
    return kGroup.first_point + k * kPoints + p;
  }
  static constexpr std::size_t points_before(std::size_t j) {
    std::size_t count = 0;
    for (std::size_t p = 0; p < kPoints; ++p)
      count += kTree<Model>.points[point(0, p)].link < index(0, j) ? 1 : 0;
    return count;
  }

  template <std::size_t j, std::size_t i>
  struct Position {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) { return link(k, j).position[i]; }
  };
  template <std::size_t j, std::size_t i>
  struct Direction {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) { return link(k, j).direction[i]; }
  };
  template <std::size_t j>
  struct Damping {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) { return joint(k, j).damping; }
  };
  template <std::size_t j>
  struct Stiffness {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) { return joint(k, j).stiffness; }
  };
  template <std::size_t j>
  struct Rest {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) { return link(k, j).sign * joint(k, j).rest; }
  };
  template <std::size_t j>
  struct Armature {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) { return joint(k, j).armature; }
  };
  template <std::size_t j>
  struct MaxVelocity {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) { return joint(k, j).max_velocity; }
  };
  template <std::size_t j>
  struct Low {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) {
      return link(k, j).sign > 0.0 ? joint(k, j).low : -joint(k, j).high;
    }
  };
  template <std::size_t j>
  struct High {
    static constexpr std::size_t kCount = GroupOf::kCount;
    static constexpr double of(std::size_t k) {
      return link(k, j).sign > 0.0 ? joint(k, j).high : -joint(k, j).low;
    }
  };
  /// A body of the link.
  template <std::size_t j, std::size_t part>
  struct Part {
    static constexpr std::size_t body(std::size_t k) { return body_on<Model>(index(k, j), part); }
    template <std::size_t i>
    struct Inertia {
      static constexpr std::size_t kCount = GroupOf::kCount;
      static constexpr double of(std::size_t k) {
        return inertia_about(Model::kBodies[body(k)], kTree<Model>.place_of_body[body(k)])[i];
      }
    };
  };
};

/// The bodies of a floating base.
template <class Model>
struct BaseOf {
  template <std::size_t part>
  struct Part {
    static constexpr std::size_t body(std::size_t /*k*/) { return body_on<Model>(kNone, part); }
    template <std::size_t i>
    struct Inertia {
      static constexpr std::size_t kCount = 1;
      static constexpr double of(std::size_t k) {
        return inertia_about(Model::kBodies[body(k)], kTree<Model>.place_of_body[body(k)])[i];
      }
    };
  };
};

}  // namespace eagerx::models::multibody

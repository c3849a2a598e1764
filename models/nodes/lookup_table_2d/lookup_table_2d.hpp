// A function of two numbers, interpolated in a grid of points.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y between the points of a grid, bilinear; `a` and `b` beyond the grid are moved to its edge.
/// Zero as long as a or b is missing; NaN if one of them is.
/// Looks up lane by lane: lanes of a SIMD vector are in different cells.
template <class Io>
class LookupTable2d {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    constexpr std::size_t kSize = elements_of<decltype(out.y)>;
    static_assert(elements_of<decltype(in.a)> == kSize && elements_of<decltype(in.b)> == kSize,
                  "LookupTable2d: `a` and `b` have the same number of elements");
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real a = newest<Real>(in.a, i);
      const Real b = newest<Real>(in.b, i);
      Real y(0);
      for (int k = 0; k < lanes<Real>; ++k) set_lane(y, k, value(lane(a, k), lane(b, k)));
      const TruthOf<Real> missing = in.a.empty() || in.b.empty();
      put(out.y, i, select(missing, Real(0), y));
    }
  }

 private:
  using Real = typename Io::Real;
  using Lane = LaneOf<Real>;
  static constexpr auto kA = constants<Real>(Io::Config::a);
  static constexpr auto kB = constants<Real>(Io::Config::b);
  static constexpr auto kTable = constants<Real>(Io::Config::table);
  static_assert(kTable.size() == kA.size() * kB.size(),
                "LookupTable2d: `table` has a value for each pair of `a` and `b`");

  static_assert(increases(Io::Config::a) && increases(Io::Config::b),
                "LookupTable2d: `a` and `b` have at least two values, each above the one before");

  struct Place {
    std::size_t cell;
    Lane part;  // 0 to 1 within the cell
  };
  template <std::size_t N>
  static Place find(const std::array<Lane, N>& points, Lane x) {
    const Lane inside = eagerx::clamp(x, points[0], points[N - 1]);
    std::size_t cell = 0;
    while (cell + 2 < N && inside >= points[cell + 1]) ++cell;
    return {cell, (inside - points[cell]) / (points[cell + 1] - points[cell])};
  }
  static Lane between(Lane low, Lane high, Lane part) {
    return (Lane(1) - part) * low + part * high;
  }
  static Lane value(Lane a, Lane b) {
    const Place row = find(kA, a);
    const Place column = find(kB, b);
    const std::size_t at = row.cell * kB.size() + column.cell;
    const std::size_t next = at + kB.size();
    return between(between(kTable[at], kTable[at + 1], column.part),
                   between(kTable[next], kTable[next + 1], column.part), row.part);
  }
};

}  // namespace eagerx::models

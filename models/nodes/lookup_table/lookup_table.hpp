// A function of one number, interpolated between points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

enum class Outside : std::uint8_t { hold, extrapolate };
enum class Interpolation : std::uint8_t { linear, previous };

/// y between the points (x[k], y[k]), for each element of the signal. Beyond the ends: the value
/// there, or along the last line. Zero before the first signal; NaN passes.
/// Linear: y[k] + (signal − x[k])·slope[k], with slopes that the compiler computes in double.
template <class Io>
class LookupTable {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < elements_of<decltype(out.y)>; ++i) {
      const TruthOf<Real> missing = in.signal.empty();
      put(out.y, i, select(missing, Real(0), value(newest<Real>(in.signal, i))));
    }
  }

 private:
  using Real = typename Io::Real;
  using Config = typename Io::Config;
  static constexpr std::size_t kPoints = Config::x.size();
  static_assert(kPoints >= 2 && Config::y.size() == kPoints,
                "LookupTable: `x` and `y` have the same number of values, at least two");
  static_assert(increases(Config::x), "LookupTable: each value of `x` is above the one before");

  static constexpr auto kX = constants<Real>(Config::x);
  static constexpr auto kY = constants<Real>(Config::y);
  static constexpr auto kSlope = [] {
    std::array<double, kPoints> slope{};
    for (std::size_t k = 0; k + 1 < kPoints; ++k) {
      slope[k] = (Config::y[k + 1] - Config::y[k]) / (Config::x[k + 1] - Config::x[k]);
    }
    return constants<Real>(slope);
  }();

  /// Every point is evaluated, so that all lanes of a SIMD vector do the same.
  static Real value(const Real& signal) {
    const Real inside = Config::outside == Outside::hold
                            ? eagerx::clamp(signal, Real(kX[0]), Real(kX[kPoints - 1]))
                            : signal;
    constexpr bool kLinear = Config::interpolation == Interpolation::linear;
    // The last line begins at the last but one point.
    constexpr std::size_t kLines = kLinear ? kPoints - 1 : kPoints;
    Real x(kX[0]);
    Real y(kY[0]);
    Real slope(kSlope[0]);
    for (std::size_t k = 1; k < kLines; ++k) {
      const auto beyond = inside >= Real(kX[k]);
      x = select(beyond, Real(kX[k]), x);
      y = select(beyond, Real(kY[k]), y);
      if constexpr (kLinear) slope = select(beyond, Real(kSlope[k]), slope);
    }
    if constexpr (!kLinear) return select(eagerx::isnan(signal), signal, y);
    const Real between = y + (inside - x) * slope;
    if constexpr (Config::outside == Outside::extrapolate) return between;
    // Without the rounding of the line.
    return select(inside >= Real(kX[kPoints - 1]), Real(kY[kPoints - 1]), between);
  }
};

}  // namespace eagerx::models

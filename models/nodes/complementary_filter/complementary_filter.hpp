// An angle from a slow measurement and its fast derivative.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y[n] = p + (1 − α)·(measured − p) with p = y[n − 1] + T·derivative and α = τ/(τ + T), element by
/// element. The first finite `measured` is y. A derivative that is not finite or has not come
/// counts as 0; without a finite `measured`, y is p.
template <class Io>
class ComplementaryFilter {
 public:
  void reset(const typename Io::States& /*states*/) {
    y_ = {};
    has_measured_ = {};
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    static_assert(elements_of<decltype(in.derivative)> == elements_of<decltype(in.measured)>,
                  "ComplementaryFilter: `measured` and `derivative` have the same number of "
                  "elements");
    const Real nan(FloatFormat<LaneOf<Real>>::nan);
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real measured = newest<Real>(in.measured, i, nan);
      const Real derivative = newest<Real>(in.derivative, i);
      const auto right = eagerx::isfinite(measured);
      const Real speed = select(eagerx::isfinite(derivative), derivative, Real(0));
      const Real predicted = y_[i] + Real(kPeriod) * speed;
      const Real error = within_turn(measured - predicted, kTurn);
      const Real corrected = within_turn(predicted + Real(kCorrection) * error, kTurn);
      const auto first = has_measured_[i] == Real(0);
      const Real after = select(right, select(first, measured, corrected), predicted);
      y_[i] = within_turn(after, kTurn);
      has_measured_[i] = select(right, Real(1), has_measured_[i]);
      put(out.y, i, y_[i]);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr double kTimeConstant = Io::Config::time_constant;
  static_assert(kTimeConstant >= 0.0, "ComplementaryFilter: `time_constant` is not negative");
  static constexpr auto kPeriod = constant<Real>(Io::Rate::period_s);
  static constexpr auto kCorrection =
      constant<Real>(Io::Rate::period_s / (kTimeConstant + Io::Rate::period_s));
  static constexpr auto kTurn = constant<Real>(Io::Config::turn);

  std::array<Real, kSize> y_{};
  std::array<Real, kSize> has_measured_{};  // 1 after the first
};

}  // namespace eagerx::models

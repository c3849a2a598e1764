// An angle from a slow measurement and its fast derivative.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y[n] = p + (1 − α)·(measured − p) with p = y[n − 1] + T·derivative and α = τ/(τ + T), element by
/// element. The first finite `measured` is y. A derivative that is not finite or is missing
/// counts as 0; without a finite `measured`, y is p. An overflow leaves y at `measured`, or as it
/// was. The sums are compensated: neither a slow turn nor a small correction is lost.
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
      const auto predicted = y_[i].plus(Real(kPeriod) * speed);
      const Real error = within_turn(measured - predicted.value, kTurn);
      const auto corrected = predicted.plus(Real(kCorrection) * error);
      const auto first = has_measured_[i] == Real(0);
      const Real after = select(right, corrected.value, predicted.value);
      const auto good = eagerx::isfinite(after) && !(right && first);
      const Real instead = select(right, measured, y_[i].value);
      const Real rest = select(right, corrected.rest, predicted.rest);
      y_[i] = {within_turn(select(good, after, instead), kTurn), select(good, rest, Real(0))};
      has_measured_[i] = select(right, Real(1), has_measured_[i]);
      put(out.y, i, y_[i].value);
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

  std::array<CompensatedSum<Real>, kSize> y_{};
  std::array<Real, kSize> has_measured_{};  // 1 after the first
};

}  // namespace eagerx::models

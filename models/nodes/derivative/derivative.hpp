// The filtered derivative of a signal.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// s/(τ·s + 1) by backward differences: y[n] = (τ·y[n − 1] + x[n] − x[n − 1])/(τ + T), element by
/// element. The first signal of an episode has the derivative 0. A signal that is not finite or
/// missing, or whose derivative overflows, changes nothing. x[n] − x[n − 1] is moved by whole turns
/// into [−turn/2, turn/2] if `turn` is above 0.
template <class Io>
class Derivative {
 public:
  void reset(const typename Io::States& /*states*/) {
    y_ = {};
    last_ = {};
    has_last_ = {};
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const Real nan(FloatFormat<LaneOf<Real>>::nan);
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real x = newest<Real>(in.signal, i, nan);
      const auto right = eagerx::isfinite(x);
      const Real change = select(has_last_[i] > Real(0), within_turn(x - last_[i], kTurn), Real(0));
      const auto after = next(y_[i], change);
      const auto good = right && eagerx::isfinite(after.value);
      y_[i] = {select(good, after.value, y_[i].value), select(good, after.rest, y_[i].rest)};
      last_[i] = select(right, x, last_[i]);
      has_last_[i] = select(right, Real(1), has_last_[i]);
      put(out.y, i, y_[i].value);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr double kTimeConstant = Io::Config::time_constant;
  static_assert(kTimeConstant >= 0.0, "Derivative: `time_constant` is not negative");
  static constexpr double kSum = kTimeConstant + Io::Rate::period_s;
  /// So slow that increments of y may be below its last digit.
  static constexpr bool kIsSlow = kTimeConstant >= Io::Rate::period_s;
  static constexpr auto kForget = constant<Real>(Io::Rate::period_s / kSum);
  static constexpr auto kKeep = constant<Real>(kTimeConstant / kSum);
  static constexpr auto kPerChange = constant<Real>(1.0 / kSum);
  static constexpr auto kTurn = constant<Real>(Io::Config::turn);

  static CompensatedSum<Real> next(const CompensatedSum<Real>& y, const Real& change) {
    if constexpr (kIsSlow) return y.plus(Real(kPerChange) * change - Real(kForget) * y.value);
    return {Real(kKeep) * y.value + Real(kPerChange) * change, Real(0)};
  }

  std::array<CompensatedSum<Real>, kSize> y_{};
  std::array<Real, kSize> last_{};
  std::array<Real, kSize> has_last_{};  // 1 after the first signal
};

}  // namespace eagerx::models

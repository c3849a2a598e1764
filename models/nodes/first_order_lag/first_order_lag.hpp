// A signal that is followed with a time constant.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// 1/(τ·s + 1) for a signal that is constant between ticks: y += (1 − exp(−T/τ))·(signal − y),
/// element by element; for τ = 0, y is the signal. A signal that is not finite, is missing or makes
/// y overflow leaves y unchanged. A reset may set τ.
template <class Io>
class FirstOrderLag {
 public:
  void reset(const typename Io::States& states) {
    for (std::size_t i = 0; i < kSize; ++i) {
      y_[i].set(each<Real>(kInitial, i));
      gain_[i].reset(gain_of(each<Real>(kTimeConstant, i)));
      tune(states, i);
    }
  }
  void tune(const typename Io::States& states) {
    for (std::size_t i = 0; i < kSize; ++i) tune(states, i);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const Real nan(FloatFormat<LaneOf<Real>>::nan);
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real x = newest<Real>(in.signal, i, nan);
      const Real gain = gain_[i].value;
      const auto moved = y_[i].plus(gain * (x - y_[i].value));
      const auto right = eagerx::isfinite(x) && eagerx::isfinite(moved.value);
      const auto passes = gain == Real(1);
      y_[i] = {select(right, select(passes, x, moved.value), y_[i].value),
               select(right, select(passes, Real(0), moved.rest), y_[i].rest)};
      put(out.y, i, y_[i].value);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kTimeConstant = constants<Real>(Io::Config::time_constant);
  static constexpr auto kInitial = constants<Real>(Io::Config::initial);
  static_assert(is_one_or_each(kTimeConstant, kSize) && is_one_or_each(kInitial, kSize),
                "FirstOrderLag: `time_constant` and `initial` have one value, or one for each "
                "element");

  void tune([[maybe_unused]] const typename Io::States& states, std::size_t i) {
    if constexpr (requires { states.time_constant; }) {
      if (states.time_constant) {
        const std::size_t at = kTimeConstant.size() == 1 ? 0 : i;
        gain_[i].set(gain_of(static_cast<Real>(element(*states.time_constant, at))));
      }
    }
  }
  static Real gain_of(const Real& time_constant) {
    // 1 − exp(−2x) = 2·tanh(x)/(1 + tanh(x)), which is exact to the last digits for a small x.
    const Real t = eagerx::tanh(Real(constant<Real>(Io::Rate::period_s / 2.0)) / time_constant);
    return select(time_constant > Real(0), (t + t) / (Real(1) + t), Real(1));
  }

  std::array<CompensatedSum<Real>, kSize> y_{};
  std::array<ResetNumber<Real>, kSize> gain_{};
};

}  // namespace eagerx::models

// Rounds a signal to steps.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = step·round(signal/step), halves away from zero, element by element. Zero before the
/// first signal; NaN passes.
template <class Io>
class Quantizer {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    constexpr std::size_t kSize = elements_of<decltype(out.y)>;
    constexpr auto kStep = constants<Real>(Io::Config::step);
    static_assert(is_one_or_each(kStep, kSize),
                  "Quantizer: `step` has one value, or one for each element");
    static_assert(above_zero(), "Quantizer: `step` is above 0");
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real step = each<Real>(kStep, i);
      put(out.y, i, eagerx::quantized(newest<Real>(in.signal, i), step));
    }
  }

 private:
  using Real = typename Io::Real;

  static constexpr bool above_zero() {
    for (const double step : Io::Config::step) {
      if (!(step > 0.0)) return false;
    }
    return true;
  }
};

}  // namespace eagerx::models

// Play of gears.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y[n] = clamp(y[n − 1], signal − width/2, signal + width/2), element by element: y moves only
/// when the signal has passed through the play. A signal that is not finite or missing leaves y
/// unchanged. A reset may set the width.
template <class Io>
class Backlash {
 public:
  void reset(const typename Io::States& states) {
    for (std::size_t i = 0; i < kSize; ++i) {
      y_[i] = each<Real>(kInitial, i);
      width_[i].reset(each<Real>(kWidth, i));
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
      const Real half = Real(constant<Real>(0.5)) * width_[i].value;
      const Real moved = eagerx::clamp(y_[i], x - half, x + half);
      y_[i] = select(eagerx::isfinite(x), moved, y_[i]);
      put(out.y, i, y_[i]);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kWidth = constants<Real>(Io::Config::width);
  static constexpr auto kInitial = constants<Real>(Io::Config::initial);
  static_assert(is_one_or_each(kWidth, kSize) && is_one_or_each(kInitial, kSize),
                "Backlash: `width` and `initial` have one value, or one for each element");

  void tune([[maybe_unused]] const typename Io::States& states, std::size_t i) {
    if constexpr (requires { states.width; }) {
      if (states.width) {
        width_[i].set(static_cast<Real>(element(*states.width, kWidth.size() == 1 ? 0 : i)));
      }
    }
  }

  std::array<Real, kSize> y_{};
  std::array<ResetNumber<Real>, kSize> width_{};
};

}  // namespace eagerx::models

// A signal within limits.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = clamp(signal, low, high), element by element; a reset may set the limits. Zero, moved into
/// them, before the first signal; NaN passes.
template <class Io>
class Saturation {
 public:
  void reset(const typename Io::States& states) {
    for (std::size_t i = 0; i < kSize; ++i) {
      low_[i].reset(each<Real>(kLow, i));
      high_[i].reset(each<Real>(kHigh, i));
      tune(states, i);
    }
  }
  void tune(const typename Io::States& states) {
    for (std::size_t i = 0; i < kSize; ++i) tune(states, i);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      put(out.y, i, eagerx::clamp(newest<Real>(in.signal, i), low_[i].value, high_[i].value));
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kLow = constants<Real>(Io::Config::low);
  static constexpr auto kHigh = constants<Real>(Io::Config::high);
  static_assert(is_one_or_each(kLow, kSize) && is_one_or_each(kHigh, kSize),
                "Saturation: `low` and `high` have one value, or one for each element");
  static_assert(in_order(Io::Config::low, Io::Config::high),
                "Saturation: `low` is not above `high`");

  void tune([[maybe_unused]] const typename Io::States& states, std::size_t i) {
    if constexpr (requires { states.low; }) {
      if (states.low) low_[i].set(static_cast<Real>(element(*states.low, at(i, kLow))));
    }
    if constexpr (requires { states.high; }) {
      if (states.high) high_[i].set(static_cast<Real>(element(*states.high, at(i, kHigh))));
    }
  }
  template <class List>
  static constexpr std::size_t at(std::size_t i, const List& list) {
    return list.size() == 1 ? 0 : i;
  }

  std::array<ResetNumber<Real>, kSize> low_{};
  std::array<ResetNumber<Real>, kSize> high_{};
};

}  // namespace eagerx::models

// A signal that does not change.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = value, or the value set by a reset.
template <class Io>
class Constant {
 public:
  void reset(const typename Io::States& states) {
    static_assert(is_one_or_each(kValue, kSize),
                  "Constant: `value` has one value for each element");
    for (std::size_t i = 0; i < kSize; ++i) {
      value_[i].reset(each<Real>(kValue, i));
      tune(states, i);
    }
  }
  void tune(const typename Io::States& states) {
    for (std::size_t i = 0; i < kSize; ++i) tune(states, i);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/,
                typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) put(out.y, i, value_[i].value);
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kValue = constants<Real>(Io::Config::value);

  void tune([[maybe_unused]] const typename Io::States& states, std::size_t i) {
    if constexpr (requires { states.value; }) {
      if (states.value) value_[i].set(static_cast<Real>(element(*states.value, i)));
    }
  }

  std::array<ResetNumber<Real>, kSize> value_{};
};

}  // namespace eagerx::models

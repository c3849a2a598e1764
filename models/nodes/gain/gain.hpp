// Every element times a factor.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>
#include <type_traits>

namespace eagerx::models {

/// y = gain·signal, element by element. Zero as long as no signal has come; NaN passes.
template <class Io>
class Gain {
 public:
  void reset([[maybe_unused]] const typename Io::States& states) {
    if constexpr (kIsTunable)
      for (std::size_t i = 0; i < kGain.size(); ++i) gain_[i].reset(states.gain, kGain[i], i);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    constexpr std::size_t kSize = elements_of<decltype(out.y)>;
    static_assert(is_one_or_each(kGain, kSize),
                  "Gain: `gain` has one value, or one for each element");
    for (std::size_t i = 0; i < kSize; ++i) put(out.y, i, gain(i) * newest<Real>(in.signal, i));
  }

 private:
  using Real = typename Io::Real;
  using States = typename Io::States;
  static constexpr auto kGain = constants<Real>(Io::Config::gain);
  static constexpr bool kIsTunable = requires(States states) { states.gain; };

  [[nodiscard]] Real gain([[maybe_unused]] std::size_t i) const {
    if constexpr (kIsTunable)
      return gain_[kGain.size() == 1 ? 0 : i].number.value;
    else
      return each<Real>(kGain, i);
  }

  struct Nothing {};
  using Numbers = std::array<Tunable<Real, true, 0>, kGain.size()>;
  [[no_unique_address]] std::conditional_t<kIsTunable, Numbers, Nothing> gain_{};
};

}  // namespace eagerx::models

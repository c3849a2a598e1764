// Every element times a factor.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = gain·signal, element by element. Zero before the first signal; NaN passes.
template <class Io>
class Gain {
 public:
  void reset(const typename Io::States& states) { tune(states); }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (kIsTunable) gain_.reset(states.gain, kGain);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    constexpr std::size_t kSize = elements_of<decltype(out.y)>;
    static_assert(is_one_or_each(kGain, kSize),
                  "Gain: `gain` has one value, or one for each element");
    for (std::size_t i = 0; i < kSize; ++i)
      put(out.y, i, each<Real>(gain_.or_constants(kGain), i) * newest<Real>(in.signal, i));
  }

 private:
  using Real = typename Io::Real;
  using States = typename Io::States;
  static constexpr auto kGain = constants<Real>(Io::Config::gain);
  static constexpr bool kIsTunable = requires(States states) { states.gain; };

  [[no_unique_address]] TunableList<Real, kGain.size(), kIsTunable, 0> gain_{};
};

}  // namespace eagerx::models

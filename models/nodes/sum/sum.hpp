// The sum of signals.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = g0·a + g1·b + g2·c + g3·d, element by element, added from left to right. An input without a
/// message counts as zero; NaN passes.
template <class Io>
class Sum {
 public:
  void reset(const typename Io::States& states) { tune(states); }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (requires { states.gains; }) gains_.reset(states.gains, kGains);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      Real sum = term(in.a, 0, i) + term(in.b, 1, i);
      std::size_t next = 2;
      if constexpr (requires { in.c; }) sum += term(in.c, next++, i);
      if constexpr (requires { in.d; }) sum += term(in.d, next++, i);
      put(out.y, i, sum);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kGains = constants<Real>(Io::Config::gains);
  static constexpr std::size_t kInputs = [] {
    std::size_t count = 2;
    if constexpr (requires(typename Io::Inputs & in) { in.c; }) ++count;
    if constexpr (requires(typename Io::Inputs & in) { in.d; }) ++count;
    return count;
  }();
  static_assert(is_one_or_each(kGains, kInputs),
                "Sum: `gains` has one value, or one for each input");

  template <class Window>
  Real term(const Window& window, std::size_t input, std::size_t i) const {
    static_assert(elements_of<Window> == kSize, "Sum: all inputs have as many elements as `a`");
    return each<Real>(gains_.or_constants(kGains), input) * newest<Real>(window, i);
  }

  using States = typename Io::States;
  static constexpr bool kTunesGains = requires(States s) { s.gains; };
  [[no_unique_address]] TunableList<Real, kGains.size(), kTunesGains, 0> gains_{};
};

}  // namespace eagerx::models

// Zero within a zone, and the excess outside of it.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = signal − clamp(signal, low, high), element by element: 0 within the zone. Zero before the
/// first signal; NaN passes.
template <class Io>
class DeadZone {
 public:
  void reset(const typename Io::States& states) { tune(states); }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (requires { states.low; }) low_.reset(states.low, kLow);
    if constexpr (requires { states.high; }) high_.reset(states.high, kHigh);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real low = each<Real>(low_.or_constants(kLow), i);
      const Real high = each<Real>(high_.or_constants(kHigh), i);
      const Real none = select(TruthOf<Real>(in.signal.empty()), low, Real(0));
      const Real x = newest<Real>(in.signal, i, none);
      put(out.y, i, x - eagerx::clamp(x, low, high));
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kLow = constants<Real>(Io::Config::low);
  static constexpr auto kHigh = constants<Real>(Io::Config::high);
  static_assert(is_one_or_each(kLow, kSize) && is_one_or_each(kHigh, kSize),
                "DeadZone: `low` and `high` have one value, or one for each element");
  static_assert(in_order(Io::Config::low, Io::Config::high), "DeadZone: `low` is not above `high`");

  using States = typename Io::States;
  static constexpr bool kTunesLow = requires(States s) { s.low; };
  static constexpr bool kTunesHigh = requires(States s) { s.high; };
  [[no_unique_address]] TunableList<Real, kLow.size(), kTunesLow, 0> low_{};
  [[no_unique_address]] TunableList<Real, kHigh.size(), kTunesHigh, 1> high_{};
};

}  // namespace eagerx::models

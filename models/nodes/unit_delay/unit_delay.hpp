// Delays a signal by one tick.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y[n] = signal[n − 1]; `initial` at first and for a signal that was missing. NaN passes.
template <class Io>
class UnitDelay {
 public:
  void reset(const typename Io::States& /*states*/) {
    for (std::size_t i = 0; i < kSize; ++i) last_[i] = each<Real>(kInitial, i);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      put(out.y, i, last_[i]);
      last_[i] = newest<Real>(in.signal, i, each<Real>(kInitial, i));
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kInitial = constants<Real>(Io::Config::initial);
  static_assert(is_one_or_each(kInitial, kSize),
                "UnitDelay: `initial` has one value, or one for each element");

  std::array<Real, kSize> last_{};
};

}  // namespace eagerx::models

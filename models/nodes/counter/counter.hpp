// How often a signal has risen.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y is how often the signal came to `threshold` or above from below, since the reset, element by
/// element; with `modulo` m above 0 it goes from m − 1 to 0. NaN and what has not come are below.
template <class Io>
class Counter {
 public:
  void reset(const typename Io::States& /*states*/) {
    count_ = {};
    was_above_ = {};
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const Real nan(FloatFormat<LaneOf<Real>>::nan);
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real x = newest<Real>(in.signal, i, nan);
      const Real is_above = select(x >= Real(kThreshold), Real(1), Real(0));
      count_[i] += is_above * (Real(1) - was_above_[i]);
      if constexpr (Io::Config::modulo > 0) {
        constexpr auto kModulo = constant<Real>(static_cast<double>(Io::Config::modulo));
        count_[i] = select(count_[i] >= Real(kModulo), Real(0), count_[i]);
      }
      was_above_[i] = is_above;
      put(out.y, i, count_[i]);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kThreshold = constant<Real>(Io::Config::threshold);

  std::array<Real, kSize> count_{};
  std::array<Real, kSize> was_above_{};
};

}  // namespace eagerx::models

// Counts the rising edges of a signal.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y counts how often the signal has risen to `threshold` or above since the reset, element by
/// element; with `modulo` m above 0, it wraps from m − 1 to 0. NaN and missing signals count as
/// below.
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
      count_[i] = count_[i].plus(is_above * (Real(1) - was_above_[i]));
      if constexpr (Io::Config::modulo > 0) {
        constexpr auto kModulo = constant<Real>(static_cast<double>(Io::Config::modulo));
        // The rest counts: a float of 2^24 or more has no ones.
        const auto full = (count_[i].value - Real(kModulo)) + count_[i].rest >= Real(0);
        count_[i] = {select(full, Real(0), count_[i].value), select(full, Real(0), count_[i].rest)};
      }
      was_above_[i] = is_above;
      put(out.y, i, count_[i].value);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kThreshold = constant<Real>(Io::Config::threshold);

  std::array<CompensatedSum<Real>, kSize> count_{};
  std::array<Real, kSize> was_above_{};
};

}  // namespace eagerx::models

// A reward that remembers: a node of a user's own, whose output a task names.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>

namespace own {

/// reward = the highest of cos(theta) at the last four ticks
template <class Io>
class Judge {
 public:
  void reset(const typename Io::States& /*states*/) {
    for (Real& height : heights_) height = Real(-1);
  }

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    const Real height = eagerx::cos(static_cast<Real>(in.theta.back()));
    heights_[tick.n % kTicks] = height;
    Real best = heights_[0];
    for (std::size_t i = 1; i < kTicks; ++i) best = eagerx::max(best, heights_[i]);
    out.reward = static_cast<float>(best);
    out.is_low = height < Real(0);
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kTicks = 4;
  Real heights_[kTicks]{};
};

}  // namespace own

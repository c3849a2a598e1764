// The filter of the exercise of tutorial 4. Not finished.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace tutorial {

/// a ← ((n − 1)·a + x)/n, a = 0 at a reset.
template <class Io>
class MovingAverage {
 public:
  void reset(const typename Io::States& /*states*/) {
    // To do: an episode begins with a = 0.
  }

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    constexpr auto kN = static_cast<float>(Io::Config::n);
    const float x = in.signal.back()[0];
    out.filtered[0] = x / kN;  // To do: the new average
  }
};

}  // namespace tutorial

// The cheapest node that depends on every message it receives.
#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

namespace eagerx::bench {

/// state ← 5·state + (sum of all messages of a and b), mixed = state ^ (state >> 7).
template <class Io>
class Mix {
 public:
  void reset(const typename Io::States& /*states*/) { state_ = 0; }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    std::uint32_t sum = sum_of(in.a);
    if constexpr (requires { in.b; }) sum += sum_of(in.b);
    state_ = kFactor * state_ + sum;
    out.mixed = state_ ^ (state_ >> kShift);
  }

 private:
  static constexpr std::uint32_t kFactor = 5;
  static constexpr std::uint32_t kShift = 7;

  template <class Window>
  static std::uint32_t sum_of(const Window& window) {
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; i < window.size(); ++i) sum += window[i];
    return sum;
  }

  std::uint32_t state_ = 0;
};

}  // namespace eagerx::bench

// A node whose member begins as a copy of another number.
#pragma once

#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace own {

template <class Io>
struct Copied {
  using Real = typename Io::Real;
  static constexpr Real kBegin = Real(0);

  void reset(const typename Io::States& /*states*/) {
    memory = kBegin;
    ticks = 0;
  }
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    memory = Real(0.5) * memory + in.signal.back()[0];
    out.y[0] = memory;
    out.count[0] = ++ticks;
  }

  Real memory = kBegin;
  std::int32_t ticks = 0;
};

}  // namespace own

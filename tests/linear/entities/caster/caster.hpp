// A node that casts to float.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace own {

template <class Io>
struct Caster {
  void reset(const typename Io::States& /*states*/) {}
  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    out.y[0] = static_cast<float>(in.signal.back()[0]);
  }
};

}  // namespace own

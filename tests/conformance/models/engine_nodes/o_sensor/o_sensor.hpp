// Reads an object's state.
#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

#include "../../fold.hpp"

namespace oracle {

template <class Io>
class OSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& simulator) {
    constexpr bool kReadsState = requires {
      in.tick;
    };
    const std::int64_t state = kReadsState ? simulator.state : 0;
    send(out, Io::Config::nid + Io::Config::index, tick, fold(in, state));
  }
};

}  // namespace oracle

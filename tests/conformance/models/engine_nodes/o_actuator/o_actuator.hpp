// Sets an input of an object.
#pragma once

#include <eagerx/rate.hpp>

#include "../../fold.hpp"

namespace oracle {

template <class Io>
class OActuator {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    simulator.inputs[Io::Config::index] = 0;
  }

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& simulator) {
    constexpr std::int64_t kFirstActuator = 10;
    const std::int64_t h = fold(in, 0);
    simulator.inputs[Io::Config::index] = h;
    send(out, Io::Config::nid + kFirstActuator + Io::Config::index, tick, h);
  }
};

}  // namespace oracle

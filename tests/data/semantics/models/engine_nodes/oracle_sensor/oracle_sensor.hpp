// Reads an object's state.
#pragma once

#include <eagerx/rate.hpp>

#include "../../fold.hpp"

namespace oracle {

template <class Io>
class OracleSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& simulator) {
    send(out, Io::Config::nid + Io::Config::index, tick, fold(in, simulator.state));
  }
};

}  // namespace oracle

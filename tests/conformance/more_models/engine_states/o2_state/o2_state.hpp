// Sets one of an object's two states.
#pragma once

namespace oracle {

template <class Io>
struct O2State {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    simulator.state[Io::Config::index] = value[0];
  }
};

}  // namespace oracle

// Sets an object's state.
#pragma once

namespace oracle {

template <class Io>
struct OState {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    simulator.state = value[0];
  }
};

}  // namespace oracle

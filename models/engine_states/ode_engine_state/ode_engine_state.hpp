// Sets the state of an object simulated by OdeEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// At a reset: simulator state := value [number of states], step size not known.
template <class Io>
struct OdeEngineState {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Simulator = typename Io::Simulator;
    static_assert(
        size_of<typename Io::State> == Simulator::Model::kStates,
        "OdeEngineState: the state must have as many elements as the object's model has states");
    for (std::size_t i = 0; i < Simulator::Model::kStates; ++i) {
      simulator.state[i] = static_cast<typename Simulator::Real>(element(value, i));
    }
    simulator.step_s = {};  // that of the last episode says nothing about this one
  }
};

}  // namespace eagerx::models

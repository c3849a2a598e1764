// Sets the state of an environment on GymEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// At a reset: state[i] of the model := factors[i] · value[i] [number of states].
template <class Io>
struct GymState {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Model = typename Io::Simulator::Model;
    using Real = typename Model::Real;
    static_assert(
        size_of<typename Io::State> == Model::kStates,
        "GymState: the state must have as many elements as the object's model has states");
    static_assert(Io::Config::factors.size() == Model::kStates,
                  "GymState: `factors` must have as many elements as the state");
    for (std::size_t i = 0; i < Model::kStates; ++i) {
      simulator.state[i] =
          static_cast<Real>(Io::Config::factors[i]) * static_cast<Real>(element(value, i));
    }
  }
};

}  // namespace eagerx::models

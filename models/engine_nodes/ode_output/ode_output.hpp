// The whole state of an object simulated by OdeEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [size] := the simulator's state at the time of the tick, rounded to the
/// scalar of the message.
template <class Io>
class OdeOutput {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    static_assert(size_of<Message> == Simulator::Model::kStates,
                  "OdeOutput: `size` must be the number of states of the object's model");
    for (std::size_t i = 0; i < Simulator::Model::kStates; ++i) {
      element(out.observation, i) = static_cast<ScalarOf<Message>>(simulator.state[i]);
    }
  }
};

}  // namespace eagerx::models

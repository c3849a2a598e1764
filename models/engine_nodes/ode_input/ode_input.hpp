// Sets the input of an object simulated by OdeEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engine_nodes/actuator.hpp>

namespace eagerx::models {

/// Input of the model [n] := action, from the time of the tick on.
template <class Io>
class OdeInput : public Actuator<Io, OdeInput<Io>> {
 public:
  using Simulator = typename Io::Simulator;

  template <class Message>
  static void apply(Simulator& simulator, const Message& action) {
    static_assert(
        size_of<Message> == Simulator::Model::kInputs,
        "OdeInput: the action must have as many elements as the object's model has inputs");
    for (std::size_t i = 0; i < size_of<Message>; ++i)
      simulator.input[i] = static_cast<typename Simulator::Real>(element(action, i));
  }
};

}  // namespace eagerx::models

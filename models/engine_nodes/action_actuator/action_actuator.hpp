// Sets the action of an environment on GymEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engine_nodes/actuator.hpp>

namespace eagerx::models {

/// Action of the next steps [n] := action; after a reset `zero_action`.
template <class Io>
class ActionActuator : public Actuator<Io, ActionActuator<Io>, Io::Config::zero_action> {
 public:
  using Simulator = typename Io::Simulator;

  template <class Message>
  static void apply(Simulator& simulator, const Message& action) {
    static_assert(size_of<Message> == Simulator::Model::kActions,
                  "ActionActuator: the action must have as many elements as the object's model");
    static_assert(Io::Config::zero_action.size() == size_of<Message>,
                  "ActionActuator: `zero_action` must have as many elements as the action");
    for (std::size_t i = 0; i < size_of<Message>; ++i)
      simulator.next_action[i] = static_cast<typename Simulator::Real>(element(action, i));
  }
};

}  // namespace eagerx::models

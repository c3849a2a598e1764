// Sets the input of a model on OpenDynamicsEngine.
#pragma once

#include <eagerx/math.hpp>
#include <models/engine_nodes/actuator.hpp>

namespace eagerx::models {

/// The input of the object's model := action.
template <class Io>
class ModelInput : public Actuator<Io, ModelInput<Io>> {
 public:
  template <class Message>
  static void apply(typename Io::Simulator& simulator, const Message& action) {
    static_assert(
        size_of<Message> == Io::Simulator::inputs(),
        "ModelInput: the action must have as many elements as the object's model has inputs");
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      using Number = typename Io::Simulator::Number;
      const auto value = static_cast<Number>(element(action, i));
      simulator.input[i] =
          eagerx::select(eagerx::isfinite(value), value, Number(LaneOf<Number>(0)));
    }
  }
};

}  // namespace eagerx::models

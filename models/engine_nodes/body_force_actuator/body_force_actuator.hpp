// Pushes a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engine_nodes/actuator.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Force on a body in its centre of mass [N] := action [3], in the axes of the world.
template <class Io>
class BodyForceActuator : public Actuator<Io, BodyForceActuator<Io>> {
 public:
  using Simulator = typename Io::Simulator;

  template <class Message>
  static void apply(Simulator& simulator, const Message& action) {
    constexpr std::size_t kBody = scene::find(Simulator::Model::kBodies, Io::Config::body);
    static_assert(kBody < Simulator::Model::kBodies.size(),
                  "BodyForceActuator: `body` is not a body of the object's model");
    static_assert(size_of<Message> == 3, "BodyForceActuator: a force has three values");
    Array<typename Simulator::Number, 3> force;
    for (std::size_t i = 0; i < 3; ++i)
      force[i] = static_cast<typename Simulator::Number>(element(action, i));
    simulator.set_force(kBody, force);
  }
};

}  // namespace eagerx::models

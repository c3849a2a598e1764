// Velocities of a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [6] := velocity [m/s] and angular velocity [rad/s] of the body.
template <class Io>
class BodyTwistSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    constexpr std::size_t kItem = scene::find(Simulator::Model::kBodies, Io::Config::body);
    static_assert(kItem < Simulator::Model::kBodies.size(),
                  "BodyTwistSensor: `body` is not a body of the object's model");
    static_assert(size_of<Message> == 6);
    const auto state = simulator.state(kItem);
    for (std::size_t i = 0; i < 3; ++i) {
      element(out.observation, i) = static_cast<ScalarOf<Message>>(state.velocity[i]);
      element(out.observation, 3 + i) = static_cast<ScalarOf<Message>>(state.angular_velocity[i]);
    }
  }
};

}  // namespace eagerx::models

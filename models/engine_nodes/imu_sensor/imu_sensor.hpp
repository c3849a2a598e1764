// An inertial measurement unit of OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [6] := specific force [m/s²] and angular velocity [rad/s], in the axes
/// of the body.
template <class Io>
class ImuSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    constexpr std::size_t kItem = scene::find(Simulator::Model::kBodies, Io::Config::body);
    static_assert(kItem < Simulator::Model::kBodies.size(),
                  "ImuSensor: `body` is not a body of the object's model");
    static_assert(size_of<Message> == 6);
    const auto state = simulator.state(kItem);
    const auto force = simulator.specific_force(kItem);
    const auto rate = rotate(inverse(state.rotation), state.angular_velocity);
    for (std::size_t i = 0; i < 3; ++i) {
      element(out.observation, i) = static_cast<ScalarOf<Message>>(force[i]);
      element(out.observation, 3 + i) = static_cast<ScalarOf<Message>>(rate[i]);
    }
  }
};

}  // namespace eagerx::models

// Velocities of a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [6] := velocity [m/s] and angular velocity [rad/s] of the body.
template <class Io>
class BodyTwistSensor : public BodySensor<Io, BodyTwistSensor<Io>> {
 public:
  static Twist numbers(const typename Io::Simulator& simulator, std::size_t body) {
    const RigidState now = simulator.state(body);
    return joined(now.velocity, now.angular_velocity);
  }
};

}  // namespace eagerx::models

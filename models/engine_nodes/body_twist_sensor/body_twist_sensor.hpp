// Velocities of a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [6] := velocity [m/s] and angular velocity [rad/s] of the body.
template <class Io>
class BodyTwistSensor : public BodySensor<Io, BodyTwistSensor<Io>> {
 public:
  static auto numbers(const typename Io::Simulator& simulator, std::size_t body) {
    return simulator.twist(body);
  }
};

}  // namespace eagerx::models

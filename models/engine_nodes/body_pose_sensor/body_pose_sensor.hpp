// Pose of a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [7] := position [m] and quaternion [w, x, y, z] of the body.
template <class Io>
class BodyPoseSensor : public BodySensor<Io, BodyPoseSensor<Io>> {
 public:
  static Pose numbers(const typename Io::Simulator& simulator, std::size_t body) {
    const RigidState now = simulator.state(body);
    return {{now.position[0], now.position[1], now.position[2], now.rotation[0], now.rotation[1],
             now.rotation[2], now.rotation[3]}};
  }
};

}  // namespace eagerx::models

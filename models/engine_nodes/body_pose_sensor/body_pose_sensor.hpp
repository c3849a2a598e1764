// Pose of a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [7] := position [m] and quaternion [w, x, y, z] of the body.
template <class Io>
class BodyPoseSensor : public BodySensor<Io, BodyPoseSensor<Io>> {
 public:
  static auto numbers(const typename Io::Simulator& simulator, std::size_t body) {
    return simulator.pose(body);
  }
};

}  // namespace eagerx::models

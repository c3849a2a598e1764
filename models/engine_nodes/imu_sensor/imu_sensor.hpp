// An inertial measurement unit of OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [6] := specific force [m/s²] and angular velocity [rad/s], in the axes
/// of the body.
template <class Io>
class ImuSensor : public BodySensor<Io, ImuSensor<Io>> {
 public:
  static auto numbers(const typename Io::Simulator& simulator, std::size_t body) {
    return simulator.imu(body);
  }
};

}  // namespace eagerx::models

// The torques that hold a robot.
#pragma once

#include <models/nodes/inverse_dynamics/inverse_dynamics.hpp>

namespace eagerx::models {

/// u [joints] = h(q, 0), clamped: InverseDynamics without velocities and accelerations.
template <class Io>
class GravityCompensation : public InverseDynamics<Io> {};

}  // namespace eagerx::models

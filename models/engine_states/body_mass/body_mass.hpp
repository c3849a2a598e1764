// Sets the mass of a body simulated by OpenDynamicsEngine.
#pragma once

#include <models/engine_states/rigid_states.hpp>

namespace eagerx::models {

/// At a reset: mass of a body [kg] := value [], the inertia in proportion.
template <class Io>
struct BodyMass {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Body = BodyNumbers<Io, 1>;
    simulator.set_mass(Body::kBody, Body::of(value)[0]);
  }
};

}  // namespace eagerx::models

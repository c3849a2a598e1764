// Moves the centre of mass of a body simulated by MultibodyEngine.
#pragma once

#include <cstddef>
#include <models/engine_states/rigid_states.hpp>

namespace eagerx::models {

/// At a reset: shift of the centre of mass [m] := value [3], in the axes of the body.
template <class Io>
struct BodyCenterOfMass {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Body = FreeBodyNumbers<Io, 3>;
    simulator.set_center_of_mass(Body::kBody, Body::of(value));
  }
};

}  // namespace eagerx::models

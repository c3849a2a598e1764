// Sets the mass of a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// At a reset: mass of a body [kg] := value [], the inertia in proportion.
template <class Io>
struct BodyMass {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Model = typename Io::Simulator::Model;
    constexpr std::size_t kItem = scene::find(Model::kBodies, Io::Config::body);
    static_assert(kItem < Model::kBodies.size(),
                  "BodyMass: `body` is not a body of the object's model");
    static_assert(size_of<typename Io::State> == 1, "BodyMass: a mass is one number");
    simulator.set_mass(kItem, static_cast<double>(element(value, 0)));
  }
};

}  // namespace eagerx::models

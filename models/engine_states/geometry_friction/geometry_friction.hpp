// Sets the friction of a geometry simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// At a reset: Coulomb's coefficient of a geometry := value [].
template <class Io>
struct GeometryFriction {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Model = typename Io::Simulator::Model;
    constexpr std::size_t kItem = scene::find(Model::kGeometries, Io::Config::geometry);
    static_assert(kItem < Model::kGeometries.size(),
                  "GeometryFriction: `geometry` is not a geometry of the object's model");
    static_assert(size_of<typename Io::State> == 1,
                  "GeometryFriction: a coefficient is one number");
    simulator.set_friction(kItem, static_cast<double>(element(value, 0)));
  }
};

}  // namespace eagerx::models

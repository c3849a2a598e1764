// Sets how rough the ground of an object is, on MultibodyEngine and OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// At a reset: the factor of the model's kHeights := value [].
template <class Io>
struct GroundRoughness {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Model = typename Io::Simulator::Model;
    static_assert(
        requires { Model::kHeights; },
        "GroundRoughness: the object's model has no heights of the ground");
    static_assert(size_of<typename Io::State> == 1, "GroundRoughness: a factor is one number");
    simulator.set_roughness(static_cast<double>(element(value, 0)));
  }
};

}  // namespace eagerx::models

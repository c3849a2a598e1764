// Heights above the ground on OpenDynamicsEngine and MultibodyEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [size] := height [m] of a point of each of `bodies` above the ground.
template <class Io>
class HeightSensor : public RigidSensor<Io, HeightSensor<Io>> {
 public:
  using Base = RigidSensor<Io, HeightSensor<Io>>;
  using typename Base::Model, typename Base::Simulator;

  template <class Message>
  static void sense(const Simulator& simulator, Message& observation) {
    static_assert(kCount == size_of<Message>,
                  "HeightSensor: `size` must be how many bodies there are");
    for (std::size_t i = 0; i < kCount; ++i)
      Base::put(observation, i, simulator.height_above_ground(place(simulator, i)));
  }

 private:
  using Number = typename Simulator::Number;
  static constexpr std::size_t kCount = scene::count_names(Io::Config::bodies);
  static constexpr auto kBodies = scene::find_all<kCount>(Model::kBodies, Io::Config::bodies);
  static_assert(scene::all_below(kBodies, Model::kBodies.size()),
                "HeightSensor: `bodies` must be bodies of the object's model");

  /// Where point `i` is in the world [m].
  static Array<Number, 3> place(const Simulator& simulator, std::size_t i) {
    constexpr auto& kPoints = Io::Config::points;
    const std::size_t first = kPoints.size() == 3 ? 0 : 3 * i;
    return simulator.point(kBodies[i], {{kPoints[first], kPoints[first + 1], kPoints[first + 2]}});
  }
};

}  // namespace eagerx::models

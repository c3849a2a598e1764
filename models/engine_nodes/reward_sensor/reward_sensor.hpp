// The rewards of an environment on GymEngine.
#pragma once

#include <models/engine_nodes/gym_sensor.hpp>

namespace eagerx::models {

/// Every tick: reward [] := the sum of the rewards since this node's last tick; without a step in
/// between, the last single reward; 0 before the first step.
template <class Io>
class RewardSensor : public GymSensor<Io, RewardSensor<Io>> {
 public:
  static auto& message(typename Io::Outputs& out) { return out.reward; }
  static auto number(typename Io::Simulator& simulator) { return simulator.take_reward(); }
};

}  // namespace eagerx::models

// The rewards of an environment on GymEngine.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: reward [] := the sum of the rewards since this node's last tick; without a step in
/// between, the last single reward; 0 before the first step.
template <class Io>
class RewardSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    simulator.begin_episode();
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.reward)>;
    element(out.reward, 0) = static_cast<ScalarOf<Message>>(simulator.take_reward());
  }
};

}  // namespace eagerx::models

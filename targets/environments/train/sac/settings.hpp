// What a training with SAC depends on besides train::Settings.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::train::sac {

/// Soft actor-critic (Haarnoja et al. 2018, arXiv:1812.05905) with two critics and a temperature
/// that learns.
struct Settings {
  std::size_t environments = 8;       // 1 to kLanes
  std::size_t horizon = 64;           // steps of each in an iteration
  std::size_t batch = 256;            // transitions of an update, a multiple of kParts * kLanes
  std::size_t capacity = 1'000'000;   // transitions that are kept
  std::uint64_t random_steps = 1000;  // of all environments, before anything is learnt
  float updates = 1.0F;               // for each step of an environment
  float step_size = 1e-3F;            // of Adam, for actor, critics and temperature
  float target_share = 0.005F;        // of the critics, which their targets take over each update
  float first_temperature = 0.1F;     // weight of the entropy against scaled rewards
  float reward_size = 1.0F;           // of returns, in their deviations
  float entropy = -1.0F;              // for each number of an action: what the temperature keeps
  float least_log_deviation = -5.0F;  // of an action before tanh
  float most_log_deviation = 2.0F;
};

}  // namespace eagerx::train::sac

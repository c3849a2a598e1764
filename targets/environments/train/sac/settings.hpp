// Settings of SAC besides train::Settings.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::train::sac {

/// Soft actor-critic (Haarnoja et al. 2018, arXiv:1812.05905) with two critics and a temperature
/// that learns. Names, ranges, meanings and first values are in options/train_settings.hpp.
struct Settings {
  std::size_t n_envs{};
  std::size_t train_freq{};   // steps of each in an iteration
  std::size_t batch_size{};   // transitions of an update, a multiple of kParts * kLanes
  std::size_t buffer_size{};  // transitions that are kept
  std::uint64_t learning_starts{};
  float utd_ratio{};                  // for each step of an environment
  float tau{};                        // of the critics, which their targets take over each update
  float ema_rate{};                   // share of the actor that the policy takes over each update
  float initial_ent_coef{};           // weight of the entropy against scaled rewards
  float target_entropy_per_action{};  // of each number of an action: what the temperature keeps
  float reward_scale{};               // deviation of the returns that critics learn
  double norm_window_steps{};  // that what scales is the mean of, at least; 0: all steps so far
};

/// The logarithm of an action's deviation before tanh.
inline constexpr float kLeastLogDeviation = -5.0F;
inline constexpr float kMostLogDeviation = 2.0F;

}  // namespace eagerx::train::sac

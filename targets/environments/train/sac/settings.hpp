// What a training with SAC depends on besides train::Settings.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::train::sac {

/// Soft actor-critic (Haarnoja et al. 2018, arXiv:1812.05905) with two critics and a temperature
/// that learns. Names, ranges, meanings and first values are in options/train_settings.hpp.
struct Settings {
  std::size_t environments{};
  std::size_t horizon{};  // steps of each in an iteration
  std::size_t batch{};    // transitions of an update, a multiple of kParts * kLanes
  std::size_t memory{};   // transitions that are kept
  std::uint64_t random_steps{};
  float updates{};            // for each step of an environment
  float target_share{};       // of the critics, which their targets take over each update
  float averaging{};          // share of the actor that the policy takes over each update
  float first_temperature{};  // weight of the entropy against scaled rewards
  float entropy{};            // of each number of an action: what the temperature keeps
  float reward_scale{};       // deviation of the returns that critics learn
  double scale_steps{};       // that what scales is the mean of, at least; 0: all steps so far
};

/// The logarithm of an action's deviation before tanh.
inline constexpr float kLeastLogDeviation = -5.0F;
inline constexpr float kMostLogDeviation = 2.0F;

}  // namespace eagerx::train::sac

// Two programs for each of pendulum.yaml and box.yaml.
#pragma once

#include <cstdint>

namespace eagerx::bench {

/// The agent's observation at the end of a run: angle [rad] or place [m].
using Seen = float;

/// Where the pendulum starts, and what the actions are.
inline constexpr float kTheta = 3.0F;
inline constexpr float kThetaDot = 0.5F;
constexpr float voltage_at(std::uint64_t step) {
  return step % 20 < 10 ? 2.0F : -2.0F;
}
constexpr float force_at(std::uint64_t step) {
  return step % 100 < 50 ? 8.0F : -8.0F;
}

/// One episode of `steps` steps.
Seen pendulum_generated(std::uint64_t steps);
Seen pendulum_by_hand(std::uint64_t steps);
Seen box_generated(std::uint64_t steps);
Seen box_by_hand(std::uint64_t steps);

}  // namespace eagerx::bench

// Two programs for examples/pendulum_swing_up.
#pragma once

#include <cstdint>

namespace eagerx::bench {

/// The agent's observation at the end of a run.
struct Seen {
  float cosine, sine, theta_dot;
};

/// Where every run starts: hanging nearly still. [rad], [rad/s]
inline constexpr float kTheta = 3.0F;
inline constexpr float kThetaDot = 0.5F;

/// One episode of `steps` steps; the agent is the policy, or does nothing.
Seen run_generated(bool policy, std::uint64_t steps);
Seen run_by_hand(bool policy, std::uint64_t steps);

}  // namespace eagerx::bench

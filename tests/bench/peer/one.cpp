// One environment of a library through the C interface: the program and a number of steps. Episodes
// begin anew where they end. A caller's work is an action from what it saw (DRIVE) and a sum.
#include <targets/environments/eagerx_environments.h>

#include <cstdio>
#include <cstdlib>

namespace {

/// Pushes CartPole's cart to where the pole leans.
[[maybe_unused]] float upright(const float* seen) {
  return seen[2] + 0.5F * seen[3] + 0.02F * seen[0] + 0.05F * seen[1] > 0.0F ? 1.0F : 0.0F;
}

/// Torque on Pendulum-v1, against its speed.
[[maybe_unused]] float brake(const float* seen) {
  return -0.25F * seen[2];
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  const long steps = std::atol(words[1]);
  eagerx_options options{};
  options.size = sizeof options;
  options.environments = 1;
  options.seed = 1;
  options.autoreset = EAGERX_SAME_STEP;
  options.threads = 1;
  eagerx_environments* environments = eagerx_create(&options);
  float seen[4] = {};
  float reward = 0.0F;
  unsigned char terminated = 0, truncated = 0;
  eagerx_rows rows{};
  rows.size = sizeof rows;
  rows.observation = seen;
  rows.reward = &reward;
  rows.terminated = &terminated;
  rows.truncated = &truncated;
  if (environments == nullptr || eagerx_reset(environments, nullptr, nullptr, seen) != 0) {
    std::fprintf(stderr, "%s\n", eagerx_error());
    return 1;
  }
  double rewards = 0.0;
  long episodes = 0;
  for (long i = 0; i < steps; ++i) {
    const float action = DRIVE(seen);
    if (eagerx_step(environments, &action, &rows) != 0) {
      std::fprintf(stderr, "%s\n", eagerx_error());
      return 1;
    }
    rewards += static_cast<double>(reward);
    episodes += terminated | truncated;
  }
  std::printf("reward %g in %ld episodes\n", rewards, episodes);
  eagerx_destroy(environments);
}

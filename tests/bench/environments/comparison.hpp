// Shared by two loops that are compared: their output, and their duration.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <vector>

namespace bench {

/// Rows that a step writes: `numbers` observed of each environment.
struct Rows {
  Rows(std::size_t environments, std::size_t numbers)
      : observation(environments * numbers), reward(environments), ends(2 * environments) {
    rows.size = sizeof(rows);
    rows.observation = observation.data();
    rows.reward = reward.data();
    rows.terminated = ends.data();
    rows.truncated = ends.data() + environments;
  }
  std::vector<float> observation, reward;
  std::vector<std::uint8_t> ends;
  eagerx_rows rows{};
};

inline double cpu_ns() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

inline constexpr std::size_t kRows = 64;  // of actions, in turn

/// ns of `count` calls with actions in turn.
template <class Step>
double timed(std::uint32_t count, const float* action, Step&& step) {
  const double start = cpu_ns();
  for (std::uint32_t i = 0; i < count; ++i) step(action + i % kRows);
  return cpu_ns() - start;
}

}  // namespace bench

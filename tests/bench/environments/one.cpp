// One environment of CartPole, kept upright: steps through the C interface, and those of the scalar
// program with what a caller wants of a step. For callgrind, which counts the functions of
// eagerx::bench (tests/bench/environments/one).
#include <targets/environments/eagerx_environments.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "cart_pole/graph.hpp"

namespace {

using graphs::cart_pole::Graph;

/// Pushes the cart to where the pole leans.
float upright(const float (&seen)[4]) {
  return seen[2] + 0.5F * seen[3] + 0.02F * seen[0] + 0.05F * seen[1] > 0.0F ? 1.0F : 0.0F;
}

float row[4];
float reward, term;
unsigned char terminated, truncated, success;
float rewards = 0.0F;  // of all steps: the same in both

}  // namespace

namespace eagerx::bench {

eagerx_environments* environments;
graphs::cart_pole::Program<> program;

[[gnu::noinline]] void library(long steps) {
  eagerx_rows rows{};
  rows.size = sizeof rows;
  rows.observation = row;
  rows.reward = &reward;
  rows.terminated = &terminated;
  rows.truncated = &truncated;
  for (long i = 0; i < steps; ++i) {
    const float action = upright(row);
    if (eagerx_step(environments, &action, &rows) != 0) std::abort();
    if (terminated != 0 || truncated != 0) std::abort();
    rewards += reward;
  }
}

[[gnu::noinline]] void scalar(long steps) {
  for (long i = 0; i < steps; ++i) {
    auto action = Graph::zero();
    Graph::for_each_action(action, [](const char*, auto& message, const auto&) {
      using Number = std::remove_cvref_t<decltype(element(message, 0))>;
      element(message, 0) = static_cast<Number>(upright(row));
    });
    const auto observation = program.step(action);
    std::size_t to = 0;
    Graph::for_each_observation(observation, [&](const char*, const auto& window, const auto&) {
      for (std::size_t k = 0; k < 4; ++k) row[to++] = static_cast<float>(element(window[0], k));
    });
    const auto& outcome = program.outcome();
    reward = static_cast<float>(outcome.reward);
    terminated = outcome.terminated ? 1 : 0;
    truncated = outcome.truncated ? 1 : 0;
    if (terminated != 0 || truncated != 0) std::abort();
    rewards += reward;
  }
}

}  // namespace eagerx::bench

int main(int count, char** words) {
  if (count < 3) return 2;
  const long steps = std::atol(words[1]);
  if (std::strcmp(words[2], "library") == 0) {
    eagerx_options options{};
    options.size = sizeof options;
    options.environments = 1;
    options.seed = 1;
    options.threads = 1;
    eagerx::bench::environments = eagerx_create(&options);
    if (eagerx::bench::environments == nullptr ||
        eagerx_reset(eagerx::bench::environments, nullptr, nullptr, row) != 0) {
      std::fprintf(stderr, "%s\n", eagerx_error());
      return 1;
    }
    eagerx::bench::library(steps);
  } else {
    const auto observation = eagerx::bench::program.reset(Graph::sample({1, 0, 0}));
    std::size_t to = 0;
    Graph::for_each_observation(observation, [&](const char*, const auto& window, const auto&) {
      for (std::size_t k = 0; k < 4; ++k) row[to++] = static_cast<float>(element(window[0], k));
    });
    eagerx::bench::scalar(steps);
  }
  std::printf("%g %g %g %g %g\n", row[0], row[1], row[2], row[3], rewards);
}

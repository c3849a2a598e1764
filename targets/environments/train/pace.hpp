// Length of a training's iterations, and when all environments are reset.
#pragma once

#include <algorithm>
#include <cstdint>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/curriculum.hpp"
#include "targets/environments/train/settings.hpp"

namespace eagerx::train {

inline constexpr std::uint32_t kLongest = 1000;  // steps of an episode that nothing ends

/// The progress of a training: a function of its settings and the number of iterations. The first
/// iterations are short, because an untrained policy learns much from few steps. Later ones are
/// longer, because the remaining improvements are smaller than the noise of few steps.
struct Pace {
  /// An iteration has a multiple of `least_steps` of each environment, and no more than the larger
  /// of both. An era has at least `steps_of_era`.
  Pace(std::uint32_t least_steps, std::uint32_t most_steps, std::uint32_t steps_of_era)
      : least(least_steps),
        most(std::max(least_steps, most_steps / least_steps * least_steps)),
        era_steps(steps_of_era) {}

  std::uint32_t least, most, era_steps;
  std::uint32_t iteration = 0;
  std::uint64_t time = 0;       // steps of each environment before this iteration
  std::uint32_t era = 0;        // all environments begin anew with each
  std::uint32_t since_era = 0;  // steps of each environment since it began

  /// Steps of each environment in this iteration: a share of all before it.
  std::uint32_t horizon() const {
    constexpr std::uint64_t kShare = 40;
    const std::uint64_t steps = time / kShare / least * least;
    return static_cast<std::uint32_t>(std::clamp(steps, std::uint64_t{least}, std::uint64_t{most}));
  }
  void next() {
    const std::uint32_t steps = horizon();
    ++iteration;
    time += steps;
    since_era += steps;
    if (since_era >= era_steps) end_era();
  }
  /// Resets all environments with the next iteration.
  void end_era() {
    if (since_era == 0) return;
    since_era = 0;
    ++era;
  }
  /// Where a training of this curriculum is.
  void go_to(std::uint32_t other, const Curriculum& curriculum = {}) {
    *this = Pace(least, most, era_steps);
    while (iteration < std::min(other, curriculum.began)) next();
    since_era = 0;
    era = curriculum.eras;
    while (iteration < other) next();
  }
};

/// Steps of an episode that nothing ends; 0: the task ends them.
inline std::uint32_t longest_of(const Description& description) {
  return description.episode_steps > 0 ? 0 : kLongest;
}

/// Eras are long enough for some episodes: PPO cuts the first ones, and SAC has few environments.
inline Pace pace_of(const Settings& settings, const Description& description) {
  constexpr std::uint32_t kLeast = 1024;  // steps
  const bool is_sac = settings.algorithm == "sac";
  const std::uint32_t episode = std::max(description.episode_steps, longest_of(description));
  const std::uint32_t era = std::max(kLeast, (is_sac ? 2 : 5) * episode);
  const auto least =
      static_cast<std::uint32_t>(is_sac ? settings.sac.train_freq : settings.n_steps);
  return {least, is_sac ? least : static_cast<std::uint32_t>(settings.max_n_steps), era};
}

}  // namespace eagerx::train

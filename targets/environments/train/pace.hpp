// How long the iterations of a training are, and when its environments begin anew.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/course.hpp"
#include "targets/environments/train/settings.hpp"

namespace eagerx::train {

inline constexpr std::uint32_t kLongest = 1000;  // steps of an episode that nothing ends

/// Between two of them, all environments of a part of them begin anew.
struct Era {
  std::uint32_t number = 0;
  std::uint32_t since = 0;  // steps of each environment since it began
};

/// Where a training is: a function of its settings and the number of iterations. The first
/// iterations are short, because whoever knows little learns much from few steps. Later ones are
/// longer: what is to be learnt then is finer than the noise of few steps.
struct Pace {
  /// An iteration has a multiple of `least_steps` of each environment, and no more than the larger
  /// of both. An era has at least `steps_of_era`. Of several parts of the environments the first
  /// ones are of different length, so that later ones begin one after the other: there is no
  /// iteration in which all environments are at the beginning of an episode, but the first ones.
  Pace(std::uint32_t least_steps, std::uint32_t most_steps, std::uint32_t steps_of_era,
       std::size_t of_parts = 1)
      : least(least_steps),
        most(std::max(least_steps, most_steps / least_steps * least_steps)),
        era_steps(steps_of_era),
        parts(of_parts) {}

  std::uint32_t least, most, era_steps;
  std::size_t parts;  // at most kParts
  std::uint32_t iteration = 0;
  std::uint64_t time = 0;          // steps of each environment before this iteration
  std::uint64_t began = 0;         // when all parts began an era at once, the last time
  std::array<Era, kParts> eras{};  // [parts]

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
    for (std::size_t part = 0; part < parts; ++part) {
      const bool is_first = began + eras[part].since + steps == time;
      eras[part].since += steps;
      if (eras[part].since >= era_steps + (is_first ? era_steps * part / parts : 0))
        eras[part] = {eras[part].number + 1, 0};
    }
  }
  /// Of a part, with the next iteration.
  bool begins(std::size_t part) const { return eras[part].since == 0; }
  bool begins_any() const {
    return std::any_of(eras.begin(), end(), [](const Era& era) { return era.since == 0; });
  }
  bool begins_all() const {
    return std::all_of(eras.begin(), end(), [&](const Era& era) {
      return era.since == 0 && era.number == eras[0].number;
    });
  }
  /// All environments begin anew with the next iteration, with an era that no part has had.
  void end_eras() {
    if (begins_all()) return;
    std::uint32_t last = 0;
    for (const Era& era : eras) last = std::max(last, era.number);
    begin_all(last + 1);
  }
  /// Where a training of this course is.
  void go_to(std::uint32_t other, const Course& course = {}) {
    *this = Pace(least, most, era_steps, parts);
    while (iteration < std::min(other, course.began)) next();
    begin_all(course.eras);
    while (iteration < other) next();
  }

 private:
  std::array<Era, kParts>::const_iterator end() const {
    return eras.begin() + static_cast<std::ptrdiff_t>(parts);
  }
  void begin_all(std::uint32_t number) {
    eras.fill({number, 0});
    began = time;
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
  const auto least = static_cast<std::uint32_t>(is_sac ? settings.sac.horizon : settings.horizon);
  return {least, is_sac ? least : static_cast<std::uint32_t>(settings.most_horizon), era,
          is_sac ? 1 : kParts};
}

}  // namespace eagerx::train

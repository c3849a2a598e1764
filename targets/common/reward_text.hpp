// Error text for a reward that is not finite, for targets with strings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <targets/common/reward_check.hpp>

namespace eagerx::target {

/// "`task.angle` is nan in step 13 of episode 2, both counted from 1". `episode` is counted from 0
/// on, `step` from 1 on.
inline std::string number_not_finite_text(const std::string& name, double value,
                                          std::uint64_t episode, std::uint64_t step) {
  const char* const what = value != value ? "nan" : value > 0 ? "infinite" : "-infinite";
  return "`task." + name + "` is " + what + " in step " + std::to_string(step) + " of episode " +
         std::to_string(episode + 1) + ", both counted from 1";
}

/// `place`: of RewardCheck.
template <class Outcome>
std::string not_finite_text(const Outcome& outcome, std::size_t place, std::uint64_t episode,
                            std::uint64_t step) {
  std::string text;
  RewardCheck<Outcome>::for_each_number(outcome, [&](std::size_t i, const char* name, auto value) {
    if (i == place) text = number_not_finite_text(name, static_cast<double>(value), episode, step);
  });
  return text;
}

}  // namespace eagerx::target

// Place of a reward that is not finite.
#pragma once

#include <cstdint>
#include <string>

namespace eagerx::environments {

/// Which environment, and when.
struct PlaceOfReward {
  std::uint32_t environment = 0;  // of the batch
  std::uint32_t number = 0;
  std::uint64_t seed = 0;
  std::uint32_t episode = 0, step = 0;  // from 0 on
};

/// "`task.angle` is nan in step 13 of episode 2, both counted from 1, of environment 3 (seed 7,
/// number 3)".
std::string not_finite_text(const char* name, double value, const PlaceOfReward& place);

}  // namespace eagerx::environments

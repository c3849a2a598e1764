// State of an environment in a batch.
#pragma once

#include <cstdint>
#include <eagerx/random.hpp>
#include <targets/environments/not_finite.hpp>

namespace eagerx::environments {

struct Episode {
  std::uint64_t seed = 0;
  std::uint32_t number = 0;
  std::uint32_t index = 0;  // since the seed was set
  bool begun = false;
  bool ended = false;
  bool traced = false;
  bool vectorized = false;  // in its lane of a SIMD group, and not in its program

  EpisodeKey key() const { return {seed, number, index}; }
  PlaceOfReward place(std::uint32_t environment, std::uint32_t steps) const {
    return {environment, number, seed, index, steps};
  }
};

}  // namespace eagerx::environments

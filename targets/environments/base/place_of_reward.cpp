#include <cstdint>
#include <string>
#include <targets/common/reward_text.hpp>
#include <targets/environments/base/place_of_reward.hpp>

namespace eagerx::environments {

std::string not_finite_text(const char* name, double value, const PlaceOfReward& place) {
  return target::number_not_finite_text(name, value, place.episode, std::uint64_t{place.step} + 1) +
         ", of environment " + std::to_string(place.environment) + " (seed " +
         std::to_string(place.seed) + ", number " + std::to_string(place.number) + ")";
}

}  // namespace eagerx::environments

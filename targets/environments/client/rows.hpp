// Memory for the results of a step of several environments.
#pragma once

#include <cstdint>
#include <vector>

#include "targets/environments/client/description.hpp"
#include "targets/environments/eagerx_environments.h"

namespace eagerx::client {

/// Row k is that of environment k. Empty members, such as terms and final observations of size 0,
/// are not written.
struct Rows {
  Rows(const Description& description, std::size_t environments)
      : observation(environments * description.observation_numbers()),
        reward(environments),
        terminated(environments),
        truncated(environments),
        success(environments) {}

  /// For eagerx_step(), valid until a member is resized.
  eagerx_rows pointers() {
    const auto place = [](auto& rows) { return rows.empty() ? nullptr : rows.data(); };
    return {.size = sizeof(eagerx_rows),
            .observation = place(observation),
            .reward = place(reward),
            .terminated = place(terminated),
            .truncated = place(truncated),
            .success = place(success),
            .terms = place(terms),
            .final_observation = place(final_observation)};
  }
  /// Whether the step was the last one of the episode.
  bool ended(std::size_t environment) const {
    return terminated[environment] != 0 || truncated[environment] != 0;
  }

  std::vector<float> observation;  // [environments][numbers of an observation]
  std::vector<float> reward;       // [environments]
  std::vector<std::uint8_t> terminated, truncated, success;  // [environments]
  std::vector<float> terms;                                  // [environments][terms]
  std::vector<float> final_observation;                      // as `observation`
};

}  // namespace eagerx::client

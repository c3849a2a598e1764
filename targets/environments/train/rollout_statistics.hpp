// Statistics of a rollout of a part of the environments, for the whole training.
#pragma once

#include <vector>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/statistics.hpp"

namespace eagerx::train {

/// Of one of kParts parts, wherever it was stepped.
struct RolloutStatistics {
  explicit RolloutStatistics(std::size_t width)
      : observation_sums(width), return_sums(1), advantage_sums(1) {}
  virtual ~RolloutStatistics() = default;
  RolloutStatistics(const RolloutStatistics&) = delete;
  RolloutStatistics& operator=(const RolloutStatistics&) = delete;

  Sums observation_sums, return_sums;
  Sums advantage_sums;            // [1]
  std::vector<Episode> episodes;  // that ended, in order of time
  std::vector<float> remembered;  // [states of actor and critic] behind the rollout
  /// [steps][count][numbers] actions since reset(), if they are remembered.
  std::vector<float> taken;
};

/// Calls `visitor` with all but the actions.
template <class Visitor, class SomeRollout>
void visit_rollout(Visitor& visitor, SomeRollout& seen) {
  for (auto* sums : {&seen.observation_sums, &seen.return_sums, &seen.advantage_sums}) {
    visitor(sums->sum);
    visitor(sums->squares);
    visitor(sums->count);
  }
  visitor(seen.episodes);
  visitor(seen.remembered);
}

}  // namespace eagerx::train

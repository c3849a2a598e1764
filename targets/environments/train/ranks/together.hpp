// Collective operations of ranks: a problem of one rank ends all of them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "targets/environments/ranks/ranks.hpp"
#include "targets/environments/train/rollout_statistics.hpp"

namespace eagerx::train {

using environments::Ranks;

/// Called by all ranks: each works, then all have the bytes of all, in order. Throws the Problem of
/// the first rank that has one, in all of them.
std::vector<std::string> together(Ranks& ranks, const std::function<void()>& work,
                                  const std::function<std::string()>& bytes);

/// Called by all ranks: each works on its share of `parts`, then all have the statistics of all
/// parts. A single rank only works.
void share_seen(Ranks& ranks, const std::vector<std::unique_ptr<RolloutStatistics>>& parts,
                const std::function<void()>& work);

}  // namespace eagerx::train

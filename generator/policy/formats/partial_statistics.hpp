// Statistics of some parts of an observation: VecNormalize's `norm_obs_keys`.
#pragma once

#include <string>

#include "generator/policy/network/network.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Whether `statistics` name some of the parts that `network` takes, and not all.
bool are_partial(const Normalization& statistics, const Network& network);

/// Gives the other parts statistics that leave them as they are, and `network` the clip in front of
/// its layers, which is of the named parts only. `policy` is its file, for people. E0627: a part
/// has another size, or is a choice.
bool complete_statistics(Normalization& statistics, Network& network, const std::string& policy,
                         PolicyProblem& problem);

}  // namespace eagerx::gen

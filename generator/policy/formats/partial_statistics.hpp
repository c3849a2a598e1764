// Statistics of some parts of an observation: VecNormalize's `norm_obs_keys`.
#pragma once

#include <string>

#include "generator/policy/network/network.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Whether `statistics` name some of the parts that `network` takes, and not all.
bool are_partial(const Normalization& statistics, const Network& network);

/// Gives the other parts statistics without effect, and puts the clip, which applies to the named
/// parts only, in front of the layers of `network`. `policy` is its file, for messages. E0627: a
/// part has another size, or is discrete.
bool complete_statistics(Normalization& statistics, Network& network, const std::string& policy,
                         PolicyProblem& problem);

}  // namespace eagerx::gen

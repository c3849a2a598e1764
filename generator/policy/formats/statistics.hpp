// Files of statistics that normalize observations.
#pragma once

#include <optional>
#include <string_view>

#include "generator/policy/network/contract.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Statistics of observations: a pickle of VecNormalize, an npz or a JSON file. E0627 and those of
/// the format.
std::optional<Normalization> read_statistics(std::string_view bytes, PolicyProblem& problem);

}  // namespace eagerx::gen

// The order of a policy's observations, by their names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/policy/network/contract.hpp"

namespace eagerx::gen {

struct TrainingOrder {
  std::vector<std::string> names;    // those of the graph, in the order of the training
  std::vector<std::string> renamed;  // "`tilt`, if it is the `angle` of the training"
};

/// nullopt if it is not clear which of `ours` an observation of the training is: one with another
/// name is the only one of its size.
std::optional<TrainingOrder> order_of_training(const std::vector<NamedPart>& theirs,
                                               const std::vector<NamedPart>& ours);

}  // namespace eagerx::gen

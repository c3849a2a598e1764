// Lowers the steps that lead to the action to layers with weights.
#pragma once

#include <optional>
#include <unordered_set>
#include <vector>

#include "generator/policy/network/graph/value.hpp"

namespace eagerx::gen {

/// The steps that lead to step `last`, each after its inputs; nullopt if they are too many or too
/// large: E0619.
std::optional<std::vector<std::int32_t>> steps_to(const std::vector<NetStep>& steps,
                                                  std::int32_t last, PolicyProblem& problem);

/// The layers from `inputs` numbers up to step `last`; `used` receives the tensors in them.
std::optional<std::vector<Layer>> make_layers(const std::vector<NetStep>& steps, std::int32_t last,
                                              std::uint32_t inputs,
                                              std::unordered_set<const NetTensor*>& used,
                                              PolicyProblem& problem);

}  // namespace eagerx::gen

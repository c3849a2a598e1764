// Finds the output of a graph that is the action. Inside formats/onnx only.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/policy/formats/onnx/graph.hpp"

namespace eagerx::gen {

/// An output of a graph, and the nodes that it depends on.
struct OnnxAction {
  int output = 0;  // its index
  OnnxDependencies needed;
};

/// The output `wanted`; if empty, the only one that can be the action: by its name, or the first
/// one if the others are known. E0751: ambiguous, or no output `wanted`.
std::optional<OnnxAction> choose_action(const onnx::GraphProto& graph, const OnnxNames& names,
                                        std::string_view wanted, PolicyProblem& problem);

/// Whether every weight of the file leads to the action or to another output, except those named as
/// a critic's or a standard deviation: E0752.
bool leads_to_outputs(const onnx::GraphProto& graph, const OnnxNames& names,
                      const OnnxAction& action, PolicyProblem& problem);

}  // namespace eagerx::gen

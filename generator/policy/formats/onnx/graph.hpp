// Names of an ONNX graph: the producer of each value, and the nodes that the action depends on, in
// order.
#pragma once

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "generator/policy/formats/onnx/onnx.pb.h"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Everything of the graph that has a name, each name once. Views into the graph.
struct OnnxNames {
  std::unordered_map<std::string_view, const onnx::TensorProto*> tensors;
  std::unordered_map<std::string_view, const onnx::ValueInfoProto*>
      inputs;  // without tensors' names
  std::unordered_map<std::string_view, const onnx::NodeProto*> producers;
};

std::optional<OnnxNames> collect_names(const onnx::GraphProto& graph, PolicyProblem& problem);

/// The dependencies of one value.
struct OnnxDependencies {
  std::vector<const onnx::NodeProto*> nodes;        // each after the nodes it needs
  std::vector<const onnx::ValueInfoProto*> inputs;  // in the order met
};

/// Walks back from `output`. A name that no node produces and a cycle are problems.
std::optional<OnnxDependencies> walk_back(std::string_view output, const OnnxNames& names,
                                          PolicyProblem& problem);

}  // namespace eagerx::gen

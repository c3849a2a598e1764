#include "generator/policy/formats/onnx/graph.hpp"

#include <fmt/core.h>

#include <cstdint>

#include "generator/policy/network/graph/tensor.hpp"

namespace eagerx::gen {
namespace {

/// The walk, with a stack of its own: a hostile file may be a million nodes deep.
class GraphWalk {
 public:
  GraphWalk(const OnnxNames& names, PolicyProblem& problem) : names_(names), problem_(problem) {}

  std::optional<OnnxDependencies> run(std::string_view output) {
    if (!visit(output)) return std::nullopt;
    while (!open_.empty()) {
      Open& top = open_.back();
      if (top.next < top.node->input_size()) {
        const std::string& input = top.node->input(top.next++);
        if (!input.empty() && !visit(input)) return std::nullopt;
        continue;
      }
      found_.nodes.push_back(top.node);
      state_[top.node] = State::done;
      open_.pop_back();
    }
    return std::move(found_);
  }

 private:
  enum class State : std::uint8_t { unseen, open, done };
  struct Open {
    const onnx::NodeProto* node;
    int next = 0;
  };

  bool visit(std::string_view name) {
    if (const auto producer = names_.producers.find(name); producer != names_.producers.end()) {
      State& state = state_[producer->second];
      if (state == State::open) {
        return refuse(problem_, "E0610",
                      fmt::format("needs `{}` to compute `{}`", printable(name), printable(name)),
                      kExportAgain);
      }
      if (state == State::unseen) {
        state = State::open;
        open_.push_back({producer->second});
      }
      return true;
    }
    if (const auto input = names_.inputs.find(name); input != names_.inputs.end()) {
      bool& seen = seen_inputs_[input->second];
      if (!seen) found_.inputs.push_back(input->second);
      seen = true;
      return true;
    }
    if (names_.tensors.contains(name)) return true;
    return refuse(problem_, "E0609",
                  fmt::format("uses `{}`, which is not in the file", printable(name)),
                  kExportAgain);
  }

  const OnnxNames& names_;
  PolicyProblem& problem_;
  OnnxDependencies found_;
  std::vector<Open> open_;
  std::unordered_map<const onnx::NodeProto*, State> state_;
  std::unordered_map<const onnx::ValueInfoProto*, bool> seen_inputs_;
};

}  // namespace

std::optional<OnnxNames> collect_names(const onnx::GraphProto& graph, PolicyProblem& problem) {
  OnnxNames names;
  std::unordered_map<std::string_view, bool> taken;
  const auto take = [&](std::string_view name) -> bool {
    if (taken.emplace(name, true).second) return true;
    return refuse(problem, "E0611", fmt::format("defines `{}` twice", printable(name)),
                  kExportAgain);
  };
  for (const onnx::TensorProto& tensor : graph.initializer()) {
    if (!take(tensor.name())) return std::nullopt;
    names.tensors.emplace(tensor.name(), &tensor);
  }
  for (const onnx::ValueInfoProto& input : graph.input()) {
    if (names.tensors.contains(input.name())) continue;  // a tensor may be listed as an input too
    if (!take(input.name())) return std::nullopt;
    names.inputs.emplace(input.name(), &input);
  }
  for (const onnx::NodeProto& node : graph.node()) {
    for (const std::string& output : node.output()) {
      if (output.empty()) continue;
      if (!take(output)) return std::nullopt;
      names.producers.emplace(output, &node);
    }
  }
  return names;
}

std::optional<OnnxDependencies> walk_back(std::string_view output, const OnnxNames& names,
                                          PolicyProblem& problem) {
  return GraphWalk(names, problem).run(output);
}

}  // namespace eagerx::gen

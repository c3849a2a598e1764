// Finds the output of a graph that is the action, by names and paths through the graph only, not by
// values.
#include "generator/policy/formats/onnx/outputs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <unordered_set>
#include <vector>

#include "generator/policy/formats/onnx/inputs.hpp"
#include "generator/policy/network/graph/evaluate.hpp"
#include "generator/policy/network/shape.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostVisits = 4'000'000;  // outputs times nodes
constexpr const char* kSayOutput =
    "say it in the graph: `agent: {policy: …, output_name: NAME}`; for `policy` with `--output "
    "NAME`";

std::string lower(std::string_view name) {
  std::string result(name);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// Names that exporters give the action. ML-Agents has both a sampled and a deterministic one.
bool is_action(std::string_view name) {
  constexpr std::array kNames = {"action",       "actions",       "continuous_actions",
                                 "mu",           "action_mean",   "mean_action",
                                 "mean",         "policy",        "pi",
                                 "actor_output", "output_action", "output_actions"};
  return ranges::contains(kNames, lower(name));
}

bool has_part(std::string_view name, const auto& parts) {
  const std::string text = lower(name);
  return ranges::any_of(parts,
                        [&](const char* part) { return text.find(part) != std::string::npos; });
}

/// Weights that take no part in a deterministic action, by their names.
bool is_no_weight_of_action(std::string_view name) {
  constexpr std::array kParts = {"value",  "critic", "vf",  "qf",     "log_std",
                                 "logstd", "sigma",  "std", "target", "discriminator"};
  return has_part(name, kParts);
}

/// The same of outputs.
bool is_no_action(std::string_view name) {
  constexpr std::array kParts = {"value",        "critic",         "log_prob",     "logprob",
                                 "neglogp",      "log_std",        "logstd",       "sigma",
                                 "std",          "entropy",        "state_out",    "hidden",
                                 "h_out",        "c_out",          "recurrent",    "memory_size",
                                 "output_shape", "version_number", "is_continuous"};
  return has_part(name, kParts);
}

bool is_layer(const onnx::NodeProto* node) {
  return has_weights(node->op_type());
}

/// Whether `tensor` is what a layer multiplies with.
bool is_weight(const onnx::TensorProto& tensor) {
  constexpr int kMatrix = 2;
  return tensor.dims_size() >= kMatrix &&
         element_count({tensor.dims().begin(), tensor.dims().end()}).value_or(0) > 1;
}

std::string shape_of(const onnx::ValueInfoProto& value) {
  if (!value.type().has_tensor_type() || !value.type().tensor_type().has_shape()) return "";
  std::vector<std::string> dims;
  for (const auto& dim : value.type().tensor_type().shape().dim()) {
    dims.push_back(dim.has_dim_value() ? fmt::format("{}", dim.dim_value()) : "?");
  }
  return fmt::format(" [{}]", join(dims, ", "));
}

/// Numbers of an answer to one observation; nothing if the file does not say it.
std::optional<std::int64_t> size_of(const onnx::ValueInfoProto& value) {
  const auto& type = value.type().tensor_type();
  if (!value.type().has_tensor_type() || !type.has_shape()) return std::nullopt;
  Dims dims;
  for (int i = 1; i < type.shape().dim_size(); ++i) {
    if (!type.shape().dim(i).has_dim_value()) return std::nullopt;
    dims.push_back(type.shape().dim(i).dim_value());
  }
  return element_count(dims);
}

class Chooser {
 public:
  Chooser(const onnx::GraphProto& graph, const OnnxNames& names, PolicyProblem& problem)
      : graph_(graph), names_(names), problem_(problem) {}

  std::optional<OnnxAction> run(std::string_view wanted) {
    if (!wanted.empty()) return said(wanted);
    const auto index = graph_.output_size() == 1 ? std::optional<int>(0) : best();
    if (!index) return std::nullopt;
    auto needed = needed_for(*index);
    if (!needed) return std::nullopt;
    return OnnxAction{*index, std::move(*needed)};
  }

  /// Every weight leads to the action, or to another output, or is known by its name.
  bool reaches_all(const OnnxAction& action) {
    Weights known = weights_of(action.needed);
    std::vector<const onnx::TensorProto*> rest;
    for (const onnx::TensorProto& tensor : graph_.initializer()) {
      if (is_weight(tensor) && !known.contains(&tensor) && !is_no_weight_of_action(tensor.name())) {
        rest.push_back(&tensor);
      }
    }
    if (rest.empty()) return true;
    for (int i = 0; i < graph_.output_size(); ++i) {
      PolicyProblem ignored;
      const auto other = i == action.output ? std::nullopt : walk_back(name(i), names_, ignored);
      if (other) known.merge(weights_of(*other));
      const auto visits =
          static_cast<std::size_t>(i + 1) * static_cast<std::size_t>(graph_.node_size());
      if (visits > kMostVisits) break;
    }
    for (const onnx::TensorProto* tensor : rest) {
      if (known.contains(tensor)) continue;
      return refuse(problem_, "E0752",
                    fmt::format("has weights that lead to none of its outputs: `{}` {}",
                                printable(tensor->name()),
                                show({tensor->dims().begin(), tensor->dims().end()})),
                    fmt::format("export the actor again; if `{}` is the action, {}",
                                printable(name(action.output)), kSayOutput));
    }
    return true;
  }

 private:
  using Nodes = std::unordered_set<const onnx::NodeProto*>;
  using Weights = std::unordered_set<const onnx::TensorProto*>;

  std::string_view name(int i) const { return graph_.output(i).name(); }
  std::optional<OnnxDependencies> needed_for(int i) { return walk_back(name(i), names_, problem_); }
  std::string listed() const {
    constexpr int kMostShown = 12;
    std::vector<std::string> texts;
    for (int i = 0; i < std::min(graph_.output_size(), kMostShown); ++i) {
      texts.push_back(fmt::format("`{}`{}", printable(name(i)), shape_of(graph_.output(i))));
    }
    if (graph_.output_size() > kMostShown) texts.emplace_back("…");
    return fmt::format("{}", join(texts, ", "));
  }

  std::optional<OnnxAction> said(std::string_view wanted) {
    for (int i = 0; i < graph_.output_size(); ++i) {
      if (name(i) != wanted) continue;
      auto needed = needed_for(i);
      if (!needed) return std::nullopt;
      return OnnxAction{i, std::move(*needed)};
    }
    return refuse(problem_, "E0751",
                  fmt::format("has no output `{}`: it has {}", printable(wanted), listed()),
                  "name one of them");
  }

  std::optional<int> best() {
    if (const auto named = by_name()) return named;
    const auto nodes = static_cast<std::size_t>(graph_.node_size());
    if (static_cast<std::size_t>(graph_.output_size()) * nodes > kMostVisits) return unknown();
    const auto first = needed_for(0);
    if (!first) return std::nullopt;
    if (ranges::none_of(first->nodes, is_layer)) return unknown();
    const Nodes on_the_way(first->nodes.begin(), first->nodes.end());
    const Weights its_own = weights_of(*first);
    const bool is_recurrent =
        ranges::any_of(first->nodes, [](const auto* node) { return has_memory(node->op_type()); });
    for (int i = 1; i < graph_.output_size(); ++i) {
      if (is_no_action(name(i)) || is_one_number_more(i)) continue;
      const auto producer = names_.producers.find(name(i));
      if (producer != names_.producers.end() && on_the_way.contains(producer->second)) continue;
      const auto other = needed_for(i);
      if (!other) return std::nullopt;
      const auto more = parameters_only_in(*other, its_own);
      if (more.empty() ? is_recurrent : ranges::all_of(more, is_no_weight_of_action)) continue;
      return unknown();
    }
    return 0;
  }
  Refused unknown() {
    return refuse(problem_, "E0751",
                  fmt::format("has {} outputs, and it is not known which one is the action: {}",
                              graph_.output_size(), listed()),
                  kSayOutput);
  }

  /// The one that is called an action; of ML-Agents' the deterministic one.
  std::optional<int> by_name() const {
    std::vector<int> found, deterministic;
    for (int i = 0; i < graph_.output_size(); ++i) {
      if (is_action(name(i))) found.push_back(i);
      if (lower(name(i)).starts_with("deterministic_")) deterministic.push_back(i);
    }
    if (!deterministic.empty()) found = deterministic;
    return found.size() == 1 ? std::optional<int>(found.front()) : std::nullopt;
  }

  /// The value or the log probability in addition to an action of several numbers, or of its own
  /// axis.
  bool is_one_number_more(int i) const {
    const auto rank = [&](int output) {
      return graph_.output(output).type().tensor_type().shape().dim_size();
    };
    if (rank(i) == 1 && rank(0) > 1) return true;
    return size_of(graph_.output(i)) == 1 && size_of(graph_.output(0)).value_or(0) > 1;
  }

  Weights weights_of(const OnnxDependencies& needed) const {
    Weights result;
    for (const onnx::NodeProto* node : needed.nodes) {
      for (const std::string& input : node->input()) {
        const auto tensor = names_.tensors.find(input);
        if (tensor != names_.tensors.end()) result.insert(tensor->second);
      }
    }
    return result;
  }
  /// Names of the tensors that only `needed` takes: matrices, and vectors of parameters.
  std::vector<std::string> parameters_only_in(const OnnxDependencies& needed,
                                              const Weights& known) const {
    std::vector<std::string> result;
    for (const onnx::TensorProto* tensor : weights_of(needed)) {
      const bool counts = is_weight(*tensor) || is_no_weight_of_action(tensor->name());
      if (counts && !known.contains(tensor)) result.push_back(tensor->name());
    }
    return result;
  }

  const onnx::GraphProto& graph_;
  const OnnxNames& names_;
  PolicyProblem& problem_;
};

}  // namespace

std::optional<OnnxAction> choose_action(const onnx::GraphProto& graph, const OnnxNames& names,
                                        std::string_view wanted, PolicyProblem& problem) {
  return Chooser(graph, names, problem).run(wanted);
}

bool leads_to_outputs(const onnx::GraphProto& graph, const OnnxNames& names,
                      const OnnxAction& action, PolicyProblem& problem) {
  return Chooser(graph, names, problem).reaches_all(action);
}

}  // namespace eagerx::gen

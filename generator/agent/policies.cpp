// Weight files of a graph: the agent's, and those of nodes, which become entities.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/cli/pipeline.hpp"
#include "generator/emit/policy_answers.hpp"
#include "generator/network/evaluate.hpp"
#include "generator/network/int8.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Rounds the weights if the graph wants them in eight bits, and says what that costs. E0709.
void round_weights(Run& run, Network& network, const AgentSpec& policy, const GoldenRows* rows) {
  const bool int8 = policy.weights && policy.weights->value == "int8";
  if (policy.max_error && !int8) {
    run.diagnostics.error("E0206", policy.max_error->span, "`max_error` goes with `weights: int8`");
  }
  if (!int8) return;
  Network rounded = with_int8_weights(network);
  const RoundingError error = rounding_error(network, rounded, rows);
  network = std::move(rounded);
  if (policy.max_error && !(error.largest <= policy.max_error->value)) {
    run.diagnostics
        .error("E0709", policy.max_error->span,
               fmt::format("with weights of eight bits the policy `{}` is farther off than {:g}",
                           network.file, policy.max_error->value))
        .help = fmt::format("its error against float32: {}", to_string(error));
    return;
  }
  run.diagnostics.note(
      policy.weights->span,
      fmt::format("weights of eight bits, error against float32: {}", to_string(error)));
}

/// Checks the policy against the rows that the graph names, and gives the program some to check.
void add_known_answers(Run& run, Network& network, const AgentSpec& policy,
                       const fs::path& folder) {
  const auto& golden = policy.golden;
  if (!golden) {
    network.self_test = self_test_rows(network, nullptr);
    return round_weights(run, network, policy, nullptr);
  }
  const std::string path = (folder / golden->value).string();
  const auto rows = read_golden(path, golden->value, golden->span, run.diagnostics);
  if (!rows || !check_normalized(network, *rows, golden->value, golden->span, run.diagnostics)) {
    return;
  }
  if (compare(network, *rows, golden->value, golden->span, run.diagnostics)) {
    network.self_test = self_test_rows(network, &*rows);
    round_weights(run, network, policy, &*rows);
  }
}

YamlValue scalar(std::string text, Span span) {
  YamlValue yaml;
  yaml.kind = YamlKind::scalar;
  yaml.text = std::move(text);
  yaml.span = span;
  return yaml;
}

YamlValue list_of(const std::vector<std::string>& texts, Span span) {
  YamlValue yaml;
  yaml.kind = YamlKind::sequence;
  yaml.span = span;
  for (const auto& text : texts) yaml.items.push_back(scalar(text, span));
  return yaml;
}

/// One number for all, or one for each of the outputs.
std::optional<YamlValue> bounds_of(const std::vector<double>& bounds, Span span) {
  if (bounds.empty()) return std::nullopt;
  std::vector<std::string> texts;
  texts.reserve(bounds.size());
  for (const double bound : bounds) texts.push_back(fmt::format("{}", bound));
  return bounds.size() == 1 ? scalar(texts.front(), span) : list_of(texts, span);
}

/// What is known of an output: a single one has the size of the network's answer and the bounds of
/// its training. What the graph says of it comes on top.
PortManifest output_port(const ComponentSpec* written, const std::string& name, bool is_single,
                         const AgentSpec& policy, const Network* network) {
  PortManifest port;
  port.name = {name, written != nullptr ? written->name.span : policy.file.span};
  port.space.span = port.name.span;
  const std::optional<SpaceSpec> said = written != nullptr ? written->space : std::nullopt;
  const Span span = port.name.span;
  const bool chooses =
      network != nullptr &&
      (policy.output ? policy.output->value : to_string(network->action_kind())) == "argmax";
  if (!said || !said->dtype)
    port.space.dtype = Spanned<std::string>{chooses ? "int64" : "float32", span};
  if (!is_single || network == nullptr) return port;
  if (!said || !said->shape) {
    port.space.shape = list_of({}, span);
    if (!chooses) port.space.shape->items = {scalar(std::to_string(network->outputs()), span)};
  }
  const double first = static_cast<double>(network->contract.first_choice.value_or(0));
  port.space.low =
      chooses ? bounds_of({first}, span) : bounds_of(network->contract.action_low, span);
  port.space.high = chooses ? bounds_of({first + network->outputs() - 1}, span)
                            : bounds_of(network->contract.action_high, span);
  return port;
}

/// A node's inputs and outputs are what the graph says; the class is generated.
Entity entity_of(const Run& run, const EntitySpec& node, const Network* network) {
  const AgentSpec& policy = *node.policy;
  Entity entity;
  entity.kind = EntityKind::node;
  entity.id = {"Policy", policy.file.span};
  entity.summary = "A trained policy.";
  entity.path = (fs::path(run.spec->path).parent_path() / policy.file.value).string();
  const std::string name = policy_namespace(node.name.value);
  const std::string& graph = run.spec->name.value;
  entity.cpp = {fmt::format("graphs::{}::{}::Node", graph, name),
                fmt::format("{}/{}.hpp", graph, name)};
  if (node.inputs) {
    for (const auto& input : *node.inputs) {
      PortManifest port;
      port.name = input.name;
      port.space.span = input.name.span;
      entity.inputs.push_back(std::move(port));
    }
  } else {
    entity.inputs.emplace_back().name = {"observation", node.name.span};
  }
  if (node.outputs) {
    for (const auto& output : *node.outputs) {
      entity.outputs.push_back(
          output_port(&output, output.name.value, node.outputs->size() == 1, policy, network));
    }
  } else {
    entity.outputs.push_back(output_port(nullptr, "action", true, policy, network));
  }
  return entity;
}

}  // namespace

std::optional<Network> read_weights(Run& run, const AgentSpec& policy) {
  const fs::path folder = fs::path(run.spec->path).parent_path();
  PolicyRequest request;
  request.path = (folder / policy.file.value).string();
  request.name = policy.file.value;
  request.span = policy.file.span;
  if (policy.normalize) {
    request.normalize_path = (folder / policy.normalize->value).string();
    request.normalize_name = policy.normalize->value;
    request.normalize_span = policy.normalize->span;
  }
  if (policy.activation) request.activation = activation_of(policy.activation->value);
  auto network = read_policy(request, run.diagnostics);
  if (!network) return network;
  for (const auto& what : network->assumed) {
    run.diagnostics.note(policy.file.span,
                         fmt::format("not in `{}`, and assumed: {}", policy.file.value, what));
  }
  if (policy.profile && policy.profile->value == "fast") network->profile = Profile::fast;
  add_known_answers(run, *network, policy, folder);
  return network;
}

void read_node_policies(Run& run) {
  for (std::size_t i = 0; i < run.spec->nodes.size(); ++i) {
    const EntitySpec& node = run.spec->nodes[i];
    if (!node.policy) continue;
    auto network = read_weights(run, *node.policy);
    run.library.entities[node.type.value] = entity_of(run, node, network ? &*network : nullptr);
    if (network) run.node_networks.push_back({i, std::move(*network)});
  }
}

std::vector<NodePolicy> node_policies(const Run& run) {
  std::vector<NodePolicy> result;
  for (const NodeNetwork& item : run.node_networks) {
    const EntitySpec& spec = run.spec->nodes[item.spec];
    const auto& nodes = run.graph->nodes;
    const auto node = std::find_if(nodes.begin(), nodes.end(),
                                   [&](const GraphNode& n) { return n.name == spec.name.value; });
    const auto index = static_cast<std::size_t>(node - nodes.begin());
    result.push_back({index, node_use(*run.graph, index, *spec.policy), &item.network});
  }
  return result;
}

}  // namespace eagerx::gen

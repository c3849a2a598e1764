#include "generator/policy/agent/node_entity.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "generator/frontend/read/number.hpp"
#include "generator/policy/agent/use.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// One number for all, or one for each of the outputs.
std::optional<YamlValue> bounds_setting(const std::vector<double>& bounds, Span span) {
  if (bounds.empty()) return std::nullopt;
  std::vector<YamlValue> numbers;
  numbers.reserve(bounds.size());
  for (const double bound : bounds) numbers.push_back(made_number(bound, span));
  return bounds.size() == 1 ? numbers.front() : made_list(std::move(numbers), span);
}

struct Bounds {
  std::vector<double> low, high;
};

/// Of what becomes of the network's outputs.
Bounds bounds_of(const Network& network, const std::string& kind) {
  if (kind == "binary") return {{0.0}, {1.0}};
  if (kind != "argmax") return {network.contract.action_low, network.contract.action_high};
  Bounds bounds;
  for (const std::uint32_t count : network.groups()) {
    bounds.low.push_back(static_cast<double>(network.contract.first_choice(bounds.low.size())));
    bounds.high.push_back(bounds.low.back() + count - 1.0);
  }
  return bounds;
}

/// The port of an output, as far as it is known: a single one has the size of the network's answer
/// and the bounds of its training. What the graph says of it comes on top.
PortManifest output_port(const ComponentSpec* written, const std::string& name, bool is_single,
                         const AgentSpec& policy, const Network* network) {
  PortManifest port;
  port.name = {name, written != nullptr ? written->name.span : policy.file.span};
  port.space.span = port.name.span;
  const std::optional<SpaceSpec> said = written != nullptr ? written->space : std::nullopt;
  const Span span = port.name.span;
  const std::string kind =
      network == nullptr
          ? ""
          : (policy.output ? policy.output->value : std::string(to_string(network->action_kind())));
  const bool is_whole = kind == "argmax" || kind == "binary";
  if (!said || !said->dtype)
    port.space.dtype = Spanned<std::string>{is_whole ? "int64" : "float32", span};
  if (!is_single || network == nullptr) return port;
  const Bounds bounds = bounds_of(*network, kind);
  if (!said || !said->shape) {
    port.space.shape = made_list({}, span);
    const std::size_t size = kind == "argmax" ? network->groups().size() : network->outputs();
    if (kind != "argmax" || size > 1) {
      port.space.shape->items = {made_number(static_cast<std::int64_t>(size), span)};
    }
  }
  port.space.low = bounds_setting(bounds.low, span);
  port.space.high = bounds_setting(bounds.high, span);
  return port;
}

}  // namespace

Entity policy_entity(const GraphSpec& spec, const EntitySpec& node, const Network* network) {
  const AgentSpec& policy = *node.policy;
  Entity entity;
  entity.kind = EntityKind::node;
  entity.id = {"Policy", policy.file.span};
  entity.summary = "A trained policy.";
  entity.path = (fs::path(spec.path).parent_path() / policy.file.value).string();
  const std::string name = policy_namespace(node.name.value);
  const std::string& graph = spec.name.value;
  entity.cpp = {fmt::format("graphs::{}::{}::Node", graph, name),
                fmt::format("{}/{}.hpp", graph, name)};
  entity.vectorized_cpp = CppClass{fmt::format("graphs::{}::vectorized::{}::Node", graph, name),
                                   fmt::format("{}/vectorized/{}.hpp", graph, name)};
  entity.vectorized = always();
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

}  // namespace eagerx::gen

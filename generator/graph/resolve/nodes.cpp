#include "generator/graph/resolve/nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "generator/frontend/parameters/requirements.hpp"
#include "generator/graph/resolve/ports.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// The output of a reset node while there is no reset.
UnresolvedInput feedthrough_of(const UnresolvedOutput& output, const std::string& node) {
  UnresolvedInput input;
  input.name = output.name;
  input.written = fmt::format("{}.feedthroughs.{}", node, output.name);
  input.span = output.span;
  if (!output.declared.like) input.declared = output.declared;
  input.feedthrough = true;
  return input;
}

bool is_selected(const Selection& components, const std::string& name) {
  // A mapping or list that is there selects; nothing there selects everything.
  return !components || find_component(components, name) != nullptr;
}

/// Whether a graph that does not list the inputs of a node has this one all the same: without a
/// connection, one that may be left out is.
bool is_wanted(const PortManifest& port, const std::string& written,
               const std::set<std::string_view>& connected) {
  return !port.optional || connected.contains(written);
}

/// The ports that connections of the graph go to.
std::set<std::string_view> connected_ports(const GraphSpec& graph) {
  std::set<std::string_view> ports;
  for (const auto& connection : graph.connections) ports.insert(connection.to.value);
  return ports;
}

/// Reports ports that are left out and that the class cannot do without.
void report_left_out(const Selection& components, const std::vector<PortManifest>& ports,
                     const EntitySpec& spec, std::string_view section, Diagnostics& diagnostics) {
  for (const auto& port : ports) {
    const std::string& name = port.name.value;
    if (port.optional || is_selected(components, name)) continue;
    diagnostics
        .error("E0310", spec.name.span,
               fmt::format("`{}.{}` cannot be left out", spec.name.value, name))
        .help = {fmt::format("add it to `{}:`, as `{}` needs it", section, spec.type.value),
                 add_to_list(name, std::string(section), spec.name.value)};
  }
}

/// `of_ports`: where problems of what its manifest says of ports go.
void add_ports(UnresolvedGraph& draft, const EntitySpec& spec, UnresolvedNode& node,
               const std::set<std::string_view>& connected, Diagnostics& of_ports) {
  const Entity* const entity = node.node.entity;
  const References references = references_of(*entity, spec.config);
  if (!report_unknown(spec.inputs, entity->inputs, *entity, "input", draft.diagnostics))
    report_left_out(spec.inputs, entity->inputs, spec, "inputs", draft.diagnostics);
  if (!report_unknown(spec.outputs, entity->outputs, *entity, "output", draft.diagnostics))
    report_left_out(spec.outputs, entity->outputs, spec, "outputs", draft.diagnostics);
  for (const auto& port : entity->inputs) {
    if (!is_selected(spec.inputs, port.name.value)) continue;
    const std::string written = spec.name.value + "." + port.name.value;
    if (!spec.inputs && !is_wanted(port, written, connected)) continue;
    UnresolvedInput input = draft_input(port, written, spec.name.span, references, of_ports);
    if (const ComponentSpec* component = find_component(spec.inputs, port.name.value)) {
      input.span = component->name.span;
      input.said = component->settings;
      if (component->space)
        input.declared =
            narrow(input.declared, partial_space(*component->space, {}, draft.diagnostics), written,
                   draft.diagnostics);
    }
    node.inputs.push_back(std::move(input));
  }
  for (const auto& port : entity->outputs) {
    if (!is_selected(spec.outputs, port.name.value)) continue;
    UnresolvedOutput output = draft_output(port, spec.name.span, references, of_ports);
    if (const ComponentSpec* component = find_component(spec.outputs, port.name.value)) {
      output.span = component->name.span;
      apply_overrides(output, *component, spec.name.value + "." + port.name.value,
                      draft.diagnostics);
    }
    if (entity->is_reset_node()) node.inputs.push_back(feedthrough_of(output, spec.name.value));
    node.outputs.push_back(std::move(output));
  }
}

}  // namespace

void add_environment(UnresolvedGraph& draft) {
  UnresolvedNode environment;
  environment.node.name = "environment";
  environment.node.role = NodeRole::environment;
  environment.node.rate_hz = draft.spec.rate.value;
  environment.node.span = draft.spec.rate.span;
  for (const auto& action : draft.spec.actions) {
    UnresolvedOutput output{action.name.value, action.name.span, {}, std::nullopt};
    output.declared.span = action.name.span;
    if (action.space) output.declared = partial_space(*action.space, {}, draft.diagnostics);
    environment.outputs.push_back(std::move(output));
  }
  for (const auto& observation : draft.spec.observations) {
    UnresolvedInput input;
    input.name = observation.name.value;
    input.written = "observations." + input.name;
    input.span = observation.name.span;
    if (observation.space)
      input.declared = partial_space(*observation.space, {}, draft.diagnostics);
    environment.inputs.push_back(std::move(input));
  }
  draft.nodes.push_back(std::move(environment));
}

void note_left_out(const EntitySpec& spec, std::string_view engine, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const auto& setting : spec.config) names.push_back(setting.name);
  for (const auto& state : spec.states) names.push_back(state.name.value);
  if (names.empty()) return;
  diagnostics.note(spec.type.span, fmt::format("{} of `{}` left out: `{}` takes its own defaults",
                                               join(names, ", "), spec.type.value, engine));
}

void add_engine(UnresolvedGraph& draft, const ResolveOptions& options) {
  if (!draft.spec.has_engine()) {
    if (draft.spec.objects.empty()) return;
    const EntitySpec& object = draft.spec.objects.front();
    draft.diagnostics
        .error("E0202", object.name.span, "missing key `engine` in the graph: objects need one")
        .help = fmt::format(
        "write `engine: {{type: …, rate: …}}`; `eagerx-gen info {}` lists the "
        "engines that it is made for",
        object.type.value);
    return;
  }
  EntitySpec spec = draft.spec.engine;
  if (!options.engine.empty() && options.engine != spec.type.value) {
    note_left_out(spec, options.engine, draft.diagnostics);
    spec.type.value = options.engine;  // another engine has other parameters: it takes its defaults
    spec.config.clear();
    spec.states.clear();
  }
  UnresolvedNode engine;
  engine.node.name = "engine";
  engine.node.role = NodeRole::engine;
  engine.node.span = draft.spec.engine.name.span;
  engine.node.rate_hz = rate_of(*spec.rate, {}, draft.diagnostics).value_or(Rational{});
  engine.node.entity = find_entity(draft.library, spec.type, EntityKind::engine, draft.diagnostics);
  if (engine.node.entity != nullptr) {
    engine.node.config = resolve_config(draft.library, *engine.node.entity, spec.config,
                                        spec.type.span, draft.diagnostics, draft.safety);
  }
  UnresolvedOutput tick{"tick", engine.node.span, {}, std::nullopt};
  tick.declared.dtype = Dtype::int64;
  tick.declared.shape.emplace();
  engine.outputs.push_back(std::move(tick));
  draft.nodes.push_back(std::move(engine));
}

UnresolvedNode node_of(UnresolvedGraph& draft, const EntitySpec& spec,
                       const std::set<std::string_view>& connected) {
  UnresolvedNode node;
  node.node.name = spec.name.value;
  node.node.role = NodeRole::node;
  node.node.span = spec.name.span;
  if (spec.rate)
    node.node.rate_hz = rate_of(*spec.rate, {}, draft.diagnostics).value_or(Rational{});
  node.node.entity = find_entity(draft.library, spec.type, EntityKind::node, draft.diagnostics);
  if (node.node.entity == nullptr) {
    draft.erroneous.insert(spec.name.value);
    return node;
  }
  const std::size_t before = draft.diagnostics.error_count();
  node.node.config = resolve_config(draft.library, *node.node.entity, spec.config, spec.type.span,
                                    draft.diagnostics, draft.safety);
  const bool is_right = draft.diagnostics.error_count() == before &&
                        meets_requirements(*node.node.entity, node.node.config);
  const MakingPorts making(draft, spec.name.value);
  Diagnostics quiet;  // what follows for ports from a parameter that is wrong is no second problem
  add_ports(draft, spec, node, connected, is_right ? draft.diagnostics : quiet);
  if (quiet.has_errors()) draft.erroneous.insert(spec.name.value);
  return node;
}

void add_nodes(UnresolvedGraph& draft) {
  const std::set<std::string_view> connected = connected_ports(draft.spec);
  for (const auto& spec : draft.spec.nodes) draft.nodes.push_back(node_of(draft, spec, connected));
}

}  // namespace eagerx::gen

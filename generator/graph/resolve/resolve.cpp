#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <unordered_map>

#include "generator/graph/resolve/connect.hpp"
#include "generator/graph/resolve/critic.hpp"
#include "generator/graph/resolve/cycles.hpp"
#include "generator/graph/resolve/float_range.hpp"
#include "generator/graph/resolve/limits.hpp"
#include "generator/graph/resolve/nodes.hpp"
#include "generator/graph/resolve/noise.hpp"
#include "generator/graph/resolve/objects.hpp"
#include "generator/graph/resolve/placement.hpp"
#include "generator/graph/resolve/render.hpp"
#include "generator/graph/resolve/resets.hpp"
#include "generator/graph/resolve/safety.hpp"
#include "generator/graph/resolve/spaces.hpp"
#include "generator/graph/resolve/stages.hpp"
#include "generator/graph/resolve/states.hpp"
#include "generator/graph/resolve/sync.hpp"
#include "generator/graph/resolve/task.hpp"
#include "generator/graph/resolve/telemetry.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// The graph's name is that of a target in its CMakeLists.txt, where CMake has some of its own.
void check_graph_name(const Spanned<std::string>& name, Diagnostics& diagnostics) {
  static constexpr std::array kOfCMake = {"all",
                                          "clean",
                                          "depend",
                                          "edit_cache",
                                          "help",
                                          "install",
                                          "list_install_components",
                                          "package",
                                          "package_source",
                                          "preinstall",
                                          "rebuild_cache",
                                          "test"};
  if (!ranges::contains(kOfCMake, name.value)) return;
  diagnostics.error("E0315", name.span, fmt::format("the name `{}` is taken", name.value)).help =
      "CMake has a target of this name, and the program gets the name of the graph: choose another "
      "one";
}

void check_names(UnresolvedGraph& draft) {
  const GraphSpec& spec = draft.spec;
  static constexpr std::array kTaken = {"actions", "observations", "environment", "engine",
                                        "agent"};
  std::unordered_map<std::string_view, const EntitySpec*> seen;
  for (const auto* entities : {&spec.objects, &spec.nodes}) {
    for (const auto& entity : *entities) {
      if (spec.task && entity.name.value == kTask) {
        draft.diagnostics.error("E0315", entity.name.span, "the name `task` is taken")
            .notes.push_back({"the task of the graph", spec.task->span, ""});
        draft.erroneous.insert(entity.name.value);
      }
      if (spec.render && entity.name.value == kRender) {
        draft.diagnostics.error("E0315", entity.name.span, "the name `render` is taken")
            .notes.push_back({"what the graph shows", spec.render->span, ""});
        draft.erroneous.insert(entity.name.value);
      }
      if (ranges::contains(kTaken, entity.name.value)) {
        draft.diagnostics
            .error("E0315", entity.name.span,
                   fmt::format("the name `{}` is taken", entity.name.value))
            .help =
            fmt::format("every graph already has {}: choose another name", join(kTaken, ", "));
        draft.erroneous.insert(entity.name.value);
      }
      const auto [same, is_new] = seen.emplace(entity.name.value, &entity);
      if (!is_new) {
        draft.diagnostics
            .error("E0315", entity.name.span,
                   fmt::format("an object is already called `{}`", entity.name.value))
            .notes.push_back({"this one", same->second->name.span, ""});
        draft.erroneous.insert(entity.name.value);
      }
    }
  }
}

/// The order in which the policy takes the observations; by name if the graph does not say it.
void resolve_agent(UnresolvedGraph& draft) {
  const AgentSpec& spec = draft.spec.agent;
  Agent& agent = draft.graph.agent;
  agent.kind = spec.kind;
  agent.span = spec.kind == AgentSpec::Kind::zero || spec.kind == AgentSpec::Kind::random
                   ? spec.span
                   : spec.file.span;
  agent.file = spec.file.value;
  agent.path = (std::filesystem::path(draft.spec.path).parent_path() / spec.file.value).string();
  if (spec.output) agent.output = spec.output->value;
  agent.trained_at = spec.trained_at;
  for (const auto& file : {spec.normalize, spec.golden}) {
    if (!file) continue;
    agent.other_files.push_back(
        (std::filesystem::path(draft.spec.path).parent_path() / file->value).string());
  }
  const auto& inputs = draft.nodes[Graph::kEnvironment].inputs;
  const std::vector<std::string> known = names_of(inputs);
  for (const auto& name : spec.observations) {
    const auto found = ranges::find(known, name.value);
    const auto earlier = ranges::find(spec.observations, name.value, &Spanned<std::string>::value);
    if (&*earlier != &name) {
      draft.diagnostics.error("E0206", name.span, fmt::format("`{}` is listed twice", name.value))
          .notes.push_back({"first here", earlier->span, ""});
    } else if (found != known.end()) {
      agent.observations.push_back(static_cast<std::size_t>(found - known.begin()));
    } else {
      draft.diagnostics
          .error("E0307", name.span, fmt::format("there is no observation `{}`", name.value))
          .help = suggestion(name.value, known, "the graph has no observations");
    }
  }
  if (!spec.observations.empty()) return;
  for (std::size_t i = 0; i < inputs.size(); ++i) agent.observations.push_back(i);
  std::ranges::sort(
      agent.observations, {}, [&](std::size_t i) -> const auto& { return inputs[i].name; });
}

/// A sample between bounds of which one is infinite is no number. Without bounds it is between the
/// ends of the dtype.
void check_random_agent(UnresolvedGraph& draft) {
  if (draft.graph.agent.kind != AgentSpec::Kind::random || draft.graph.nodes.empty()) return;
  const auto infinite = [](double bound) { return std::isinf(bound); };
  for (const auto& action : draft.graph.environment().outputs) {
    const Space& space = action.space;
    if (ranges::none_of(space.low, infinite) && ranges::none_of(space.high, infinite)) continue;
    auto& problem = draft.diagnostics.error(
        "E0326", draft.graph.agent.span,
        fmt::format("no random `{}` can be sampled: its bounds are not finite", action.name));
    problem.notes.push_back({"this action", action.span, ""});
    problem.help = fmt::format(
        "give finite ones: `actions: {{{}: {{space: {{low: …, high: …}}}}}}`", action.name);
  }
}

/// The program counts the ticks of the environment that a reset may take.
void check_reset_timeout(UnresolvedGraph& draft) {
  constexpr std::int64_t kMostTicks = std::int64_t{1} << 62;
  if (!draft.spec.reset_timeout_s) return;
  const Spanned<Rational>& timeout = *draft.spec.reset_timeout_s;
  draft.graph.reset_timeout_s = timeout.value;
  if (timeout.value * draft.spec.rate.value <= Rational(kMostTicks)) return;
  draft.diagnostics.error("E0323", timeout.span, "`reset_timeout` is out of range").label =
      "these are more ticks of the environment than can be counted";
}

/// `--engine` names no place in a file, so its problem is found before anything points at the
/// graph's engine.
bool check_engine_option(const GraphSpec& spec, const Library& library,
                         const ResolveOptions& options, Diagnostics& diagnostics) {
  if (options.engine.empty()) return true;
  if (!spec.has_engine()) {
    diagnostics.error("E0303", {}, "there is no engine to replace: the graph has none").help =
        "leave out `--engine`, or write `engine:` in the graph";
    return false;
  }
  return find_entity(library, {options.engine, {}}, EntityKind::engine, diagnostics) != nullptr;
}

}  // namespace

std::vector<std::string> Output::names() const {
  std::vector<std::string> result = sensors;
  std::erase_if(result, [&](const std::string& sensor) { return contains(converted, sensor); });
  return result;
}

std::vector<std::string> GraphNode::ports_of(const Output& output) const {
  std::vector<std::string> ports = output.names();
  if (ports.empty())
    ports.push_back((role == NodeRole::environment ? "actions" : name) + "." + output.name);
  return ports;
}

std::vector<std::string> Graph::aliases_of(const GraphNode& node, const Output& output) const {
  std::vector<std::string> aliases;
  for (const std::string& port : node.ports_of(output)) {
    const auto [begin, end] = composite_ports.equal_range(port);
    for (auto each = begin; each != end; ++each) aliases.push_back(each->second);
  }
  return aliases;
}

std::string name_of_source(const Graph& graph, const Input& input) {
  const GraphNode& node = graph.nodes[input.source_node];
  if (!input.sensor.empty()) return input.sensor;
  const Output& output = node.outputs[input.source_output];
  if (!output.sensors.empty()) return output.sensors.front();
  return (node.role == NodeRole::environment ? "actions" : node.name) + "." + output.name;
}

std::optional<Graph> resolve(const GraphSpec& spec, const Library& library,
                             const ResolveOptions& options, Diagnostics& diagnostics) {
  UnresolvedGraph draft{spec, library, diagnostics, {}, {}, {}, {}, safety_references(spec)};
  draft.graph.name = spec.name.value;
  draft.graph.path = spec.path;
  draft.graph.file_name = std::filesystem::path(spec.path).filename().string();
  draft.graph.double_precision = (options.real.empty() ? spec.real : options.real) == "double";
  draft.graph.span = spec.name.span;
  for (const CompositeSpec& composite : spec.composites)
    for (const auto& [port, inner] : composite.outputs)
      for (const std::string& each : inner)
        draft.graph.composite_ports.emplace(each, composite.name + "." + port);
  if (!check_engine_option(spec, library, options, diagnostics)) return std::nullopt;
  check_graph_name(spec.name, diagnostics);
  check_names(draft);
  add_environment(draft);
  add_engine(draft, options);
  add_nodes(draft);
  add_objects(draft);
  add_task(draft);
  add_render(draft);
  connect(draft);
  add_noise(draft);
  let_task_skip(draft);
  resolve_states(draft);
  resolve_reset_targets(draft);
  resolve_agent(draft);
  check_cycles(draft);
  place_parts(draft, options.placement.empty() ? spec.placement : options.placement);
  resolve_spaces(draft);
  resolve_task(draft);
  resolve_critic(draft);
  resolve_stages(draft);
  resolve_render(draft);
  resolve_telemetry(draft);
  resolve_safety(draft);
  if (!diagnostics.has_errors()) find_applied_spaces(draft.graph);
  check_random_agent(draft);
  check_reset_timeout(draft);
  if (!diagnostics.has_errors()) check_resets(draft.graph, diagnostics);
  check_sync(draft);
  check_limits(draft);
  check_float_range(draft);
  if (diagnostics.has_errors()) return std::nullopt;
  return std::move(draft.graph);
}

}  // namespace eagerx::gen

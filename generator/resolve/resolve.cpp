#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/resolve/draft.hpp"

namespace eagerx::gen {
namespace {

void check_names(const GraphSpec& spec, Diagnostics& diagnostics) {
  static constexpr std::array kTaken = {"actions", "observations", "environment", "engine", "agent"};
  std::vector<const EntitySpec*> seen;
  for (const auto* entities : {&spec.objects, &spec.nodes}) {
    for (const auto& entity : *entities) {
      if (std::find(kTaken.begin(), kTaken.end(), entity.name.value) != kTaken.end()) {
        diagnostics.error("E0315", entity.name.span, fmt::format("the name `{}` is taken", entity.name.value));
      }
      const auto same = std::find_if(seen.begin(), seen.end(), [&](const EntitySpec* s) { return s->name.value == entity.name.value; });
      if (same != seen.end()) {
        diagnostics.error("E0315", entity.name.span, fmt::format("an object is already called `{}`", entity.name.value))
            .notes.push_back({"here", (*same)->name.span, ""});
      }
      seen.push_back(&entity);
    }
  }
}

/// The order in which the policy takes the observations; by name if the graph does not say it.
void resolve_agent(Draft& draft) {
  const AgentSpec& spec = draft.spec.agent;
  Agent& agent = draft.graph.agent;
  agent.kind = spec.kind;
  agent.span = spec.kind == AgentSpec::Kind::zero || spec.kind == AgentSpec::Kind::random ? spec.span : spec.file.span;
  agent.file = spec.file.value;
  agent.path = (std::filesystem::path(draft.spec.path).parent_path() / spec.file.value).string();
  if (spec.output) agent.squashed = spec.output->value == "squashed";
  const auto& inputs = draft.nodes[Graph::kEnvironment].inputs;
  std::vector<std::string> known;
  for (const auto& input : inputs) known.push_back(input.name);
  for (const auto& name : spec.observations) {
    const auto found = std::find(known.begin(), known.end(), name.value);
    if (found != known.end()) {
      agent.observations.push_back(static_cast<std::size_t>(found - known.begin()));
      continue;
    }
    auto& problem = draft.diagnostics.error("E0307", name.span, fmt::format("there is no observation `{}`", name.value));
    const std::string near = nearest(name.value, known);
    problem.help = near.empty() ? fmt::format("there is {}", fmt::join(known, ", ")) : fmt::format("did you mean `{}`?", near);
  }
  if (!spec.observations.empty()) return;
  for (std::size_t i = 0; i < inputs.size(); ++i) agent.observations.push_back(i);
  std::sort(agent.observations.begin(), agent.observations.end(), [&](std::size_t a, std::size_t b) { return inputs[a].name < inputs[b].name; });
}

/// `--engine` names no place in a file, so its problem is found before anything points at the graph's engine.
bool check_engine_option(const Library& library, const ResolveOptions& options, Diagnostics& diagnostics) {
  if (options.engine.empty()) return true;
  return find_entity(library, {options.engine, {}}, EntityKind::engine, diagnostics) != nullptr;
}

}  // namespace

std::optional<Graph> resolve(const GraphSpec& spec, const Library& library, const ResolveOptions& options,
                             Diagnostics& diagnostics) {
  Draft draft{spec, library, diagnostics, {}, {}, {}};
  draft.graph.name = spec.name.value;
  draft.graph.path = spec.path;
  draft.graph.file_name = std::filesystem::path(spec.path).filename().string();
  draft.graph.double_precision = (options.real.empty() ? spec.real : options.real) == "double";
  draft.graph.span = spec.name.span;
  if (!check_engine_option(library, options, diagnostics)) return std::nullopt;
  check_names(spec, diagnostics);
  add_environment(draft);
  add_engine(draft, options);
  add_nodes(draft);
  add_objects(draft);
  connect(draft);
  resolve_states(draft);
  resolve_agent(draft);
  // Spaces are only worth following when everything is connected; the rest only makes sense with spaces.
  resolve_spaces(draft);
  if (diagnostics.has_errors()) return std::nullopt;
  check_cycles(draft.graph, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return std::move(draft.graph);
}

}  // namespace eagerx::gen

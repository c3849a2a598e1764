#include "generator/graph/resolve/render.hpp"

#include <fmt/format.h>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::uint64_t kSceneColumns = 16;  // eagerx/scene.hpp

bool is_scene(const Space& space) {
  return space.dtype == Dtype::float32 && space.shape.size() == 2 &&
         space.shape.back() == kSceneColumns;
}
bool is_image(const Space& space) {
  const auto& shape = space.shape;
  return space.dtype == Dtype::uint8 &&
         (shape.size() == 2 || (shape.size() == 3 && shape.back() == 3));
}

std::shared_ptr<const Entity> render_entity(const GraphSpec& spec) {
  PortManifest source;
  source.name = {"source", spec.render->source.span};
  Entity entity;
  entity.kind = EntityKind::node;
  entity.id = {"Render", spec.render->span};
  entity.summary = "What a program shows.";
  entity.path = spec.path;
  entity.cpp = {"eagerx::Render", ""};  // in every program.hpp that draws
  entity.inputs.push_back(std::move(source));
  return std::make_shared<const Entity>(std::move(entity));
}

/// Whether an engine node acts on the engine, or passes on what does.
bool acts(const Graph& graph, const GraphNode& node) {
  if (node.role != NodeRole::engine_node) return false;
  return ranges::any_of(node.inputs, [&](const Input& input) {
    return input.actuator || (input.source_node != Graph::kEngine && !input.skip &&
                              acts(graph, graph.nodes[input.source_node]));
  });
}

/// Against the flow: a node whose messages go to drawn nodes only is one of them.
void mark_drawn(Graph& graph) {
  std::vector<std::vector<std::size_t>> readers(graph.nodes.size());
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    for (const auto& input : graph.nodes[n].inputs) readers[input.source_node].push_back(n);
  }
  std::vector<std::size_t> todo = {graph.render->node};
  while (!todo.empty()) {
    GraphNode& node = graph.nodes[todo.back()];
    todo.pop_back();
    node.drawn = true;
    for (const auto& input : node.inputs) {
      const GraphNode& source = graph.nodes[input.source_node];
      const bool can_wait = source.role == NodeRole::node || source.role == NodeRole::engine_node;
      const bool only_here = ranges::all_of(readers[input.source_node],
                                            [&](std::size_t n) { return graph.nodes[n].drawn; });
      if (can_wait && only_here && !source.drawn && !source.is_reset_node() && !acts(graph, source))
        todo.push_back(input.source_node);
    }
  }
}

/// The state of a node that `node.parameter` names, if it can be set while an episode runs.
const State* running_state(const Graph& graph, const std::string& name) {
  for (const GraphNode& node : graph.nodes) {
    if (node.role != NodeRole::node || !name.starts_with(node.name + ".")) continue;
    const auto state = ranges::find(node.states, name.substr(node.name.size() + 1), &State::name);
    if (state != node.states.end() && state->settable && state->tunes_running) return &*state;
  }
  return nullptr;
}

void check_key(const RenderKey& key, UnresolvedGraph& draft) {
  const std::string& name = key.parameter.value;
  const State* state = running_state(draft.graph, name);
  if (state == nullptr) {
    draft.diagnostics
        .error(
            "E0364", key.parameter.span,
            fmt::format("the key `{}` cannot set `{}` while the graph runs", key.key.value, name))
        .help = fmt::format(
        "write `tunable: [{}]`; `eagerx-gen info` lists what is tunable while it runs", name);
  } else if (state->space.size() != key.add.size()) {
    draft.diagnostics
        .error("E0364", key.key.span,
               fmt::format("the key `{}` adds {} to `{}`, which has {}", key.key.value,
                           counted(key.add.size(), "number"), name,
                           counted(state->space.size(), "number")))
        .help = "give `add` a number for each";
  }
}

}  // namespace

void add_render(UnresolvedGraph& draft) {
  if (!draft.spec.render) return;
  const RenderSpec& spec = *draft.spec.render;
  Render& render = draft.graph.render.emplace();
  render.node = draft.nodes.size();
  render.span = spec.span;
  render.entity = render_entity(draft.spec);
  draft.render = render.node;
  UnresolvedNode node;
  node.node.name = kRender;
  node.node.role = NodeRole::node;
  node.node.entity = render.entity.get();
  node.node.rate_hz = spec.rate ? spec.rate->value : draft.spec.rate.value;
  node.node.span = spec.span;
  UnresolvedInput source;
  source.name = "source";
  source.written = "render.source";
  source.span = spec.source.span;
  node.inputs.push_back(std::move(source));
  draft.nodes.push_back(std::move(node));
}

void resolve_render(UnresolvedGraph& draft) {
  Graph& graph = draft.graph;
  if (!draft.render || graph.nodes.empty()) return;
  const Input& source = graph.nodes[*draft.render].inputs.front();
  if (!is_scene(source.space) && !is_image(source.space)) {
    draft.diagnostics
        .error("E0360", draft.spec.render->source.span,
               fmt::format("`{}` cannot be shown: it is {}", draft.spec.render->source.value,
                           source.space.describe()))
        .help =
        "give the output of a drawing, float32 [rows, 16], or an image, uint8 [height, width, 3] "
        "or [height, width]";
    return;
  }
  for (const RenderKey& key : draft.spec.render->keys) check_key(key, draft);
  mark_drawn(graph);
  if (!graph.placement) return;
  // Pictures are the hub's.
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (graph.nodes[n].drawn) graph.placement->part_of[n] = Placement::kHub;
  }
}

}  // namespace eagerx::gen

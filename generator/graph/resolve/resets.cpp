#include "generator/graph/resolve/resets.hpp"

#include <fmt/format.h>

#include "generator/graph/resolve/processors.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// The states of an object or a node, and where they are.
struct Owner {
  std::optional<std::size_t> object;
  std::size_t node = 0;
  const std::vector<State>* states = nullptr;
  const Entity* entity = nullptr;
};

class ResetTargetResolver {
 public:
  explicit ResetTargetResolver(UnresolvedGraph& draft) : draft_(draft) {}

  void run() {
    for (const auto& connection : draft_.spec.connections) {
      if (is_reset_target(connection)) connect(connection);
    }
    for (const auto& node : draft_.nodes) report_idle(node);
  }

 private:
  Diagnostics& diagnostics() { return draft_.diagnostics; }

  void connect(const ConnectionSpec& connection) {
    UnresolvedNode* node = find_reset_node(connection.to);
    const Owner owner = find_owner(connection.from);
    if (node == nullptr || owner.states == nullptr) return;
    const std::string name = parse_port(connection.to.value).name;
    const PortManifest* port = node->node.entity->reset_target(name);
    if (port == nullptr) {
      diagnostics()
          .error("E0307", connection.to.span,
                 fmt::format("`{}` has no target `{}`", node->node.entity->id.value, name))
          .help = suggestion(name, names_of(node->node.entity->reset_targets), "it has no targets");
      return;
    }
    refuse_settings(connection);
    const auto state = find_state(owner, connection.from);
    if (!state || !is_free(*node, name, connection) || !is_only(owner, *state, connection)) return;
    add(*node, *port, owner, *state, connection);
  }

  /// Nothing is sent along such a connection: the state is asked for once, when a reset begins.
  void refuse_settings(const ConnectionSpec& connection) {
    const ConnectionSettings& settings = connection.settings;
    const auto refuse = [&](const char* key, const auto& setting) {
      if (!setting) return;
      diagnostics()
          .error("E0318", setting->span,
                 fmt::format("`{}` cannot have `{}`", connection.to.value, key))
          .help = "a target gets its state once, when a reset begins: only `processor` can be set";
    };
    refuse("window", settings.window);
    refuse("delay", settings.delay);
    refuse("delay", settings.random_delay);
    refuse("max_delay", settings.max_delay);
    refuse("skip", settings.skip);
  }

  UnresolvedNode* find_reset_node(const Spanned<std::string>& to) {
    const std::string name = parse_port(to.value).owner;
    for (auto& node : draft_.nodes) {
      if (node.node.name != name || node.node.role != NodeRole::node) continue;
      if (node.node.entity == nullptr) return nullptr;  // reported already
      if (node.node.entity->is_reset_node()) return &node;
      diagnostics()
          .error(
              "E0307", to.span,
              fmt::format("`{}` is a {}, which has no targets", name, node.node.entity->id.value))
          .help = "only reset nodes have targets";
      return nullptr;
    }
    std::vector<std::string> known;
    for (const auto& node : draft_.nodes) {
      if (node.node.entity != nullptr && node.node.entity->is_reset_node())
        known.push_back(node.node.name);
    }
    if (!draft_.erroneous.contains(name)) {
      diagnostics()
          .error("E0309", to.span, fmt::format("there is no reset node `{}` in this graph", name))
          .help = suggestion(name, known, "the graph has no reset nodes");
    }
    return nullptr;
  }

  Owner find_owner(const Spanned<std::string>& from) {
    const auto& [name, section, state] = parse_port(from.value);
    if (section != "states") {
      diagnostics().error("E0309", from.span, fmt::format("`{}` is not a state", from.value)).help =
          "a target takes a state: write `from: object.states.name`";
      return {};
    }
    for (std::size_t i = 0; i < draft_.graph.objects.size(); ++i) {
      const Object& object = draft_.graph.objects[i];
      if (object.name == name) return {i, 0, &object.states, object.entity};
    }
    for (std::size_t i = 0; i < draft_.nodes.size(); ++i) {
      const GraphNode& node = draft_.nodes[i].node;
      if (node.name == name && node.role == NodeRole::node)
        return {std::nullopt, i, &node.states, node.entity};
    }
    if (!draft_.erroneous.contains(name)) {
      diagnostics()
          .error("E0309", from.span,
                 fmt::format("there is nothing called `{}` in this graph", name))
          .help = suggestion(name, names_of(draft_.graph.objects), "the graph has no objects");
    }
    return {};
  }

  std::optional<std::size_t> find_state(const Owner& owner, const Spanned<std::string>& from) {
    const auto [name, section, state] = parse_port(from.value);
    std::vector<std::string> known;
    for (std::size_t i = 0; i < owner.states->size(); ++i) {
      if (!(*owner.states)[i].settable) continue;
      if ((*owner.states)[i].name == state) return i;
      known.push_back((*owner.states)[i].name);
    }
    if (owner.entity == nullptr || draft_.erroneous.contains(name)) return std::nullopt;
    const bool exists = owner.entity->state(state) != nullptr;
    auto& problem = diagnostics().error(
        "E0307", from.span,
        exists ? fmt::format("`{}` is not among the states of `{}`", state, name)
               : fmt::format("`{}` has no state `{}`", owner.entity->id.value, state));
    problem.help = exists ? Help(fmt::format("add it to `states:` of `{}`", name),
                                 add_to_list(state, "states", name))
                          : suggestion(state, known, "it has no states in this graph");
    return std::nullopt;
  }

  bool is_free(const UnresolvedNode& node, const std::string& name,
               const ConnectionSpec& connection) {
    for (const auto& reset_target : node.node.reset_targets) {
      if (reset_target.name != name) continue;
      diagnostics()
          .error("E0311", connection.to.span,
                 fmt::format("`{}` is connected twice", connection.to.value))
          .notes.push_back({"the first connection", reset_target.span, ""});
      return false;
    }
    return true;
  }

  /// A state is brought about by one reset node: two would drive it to and fro.
  bool is_only(const Owner& owner, std::size_t state, const ConnectionSpec& connection) {
    for (const auto& other : draft_.nodes) {
      for (const auto& target : other.node.reset_targets) {
        if (target.state != state || target.object != owner.object || target.node != owner.node)
          continue;
        auto& problem = diagnostics().error("E0808", connection.to.span,
                                            fmt::format("`{}` is the target of `{}` already",
                                                        connection.from.value, other.node.name));
        problem.notes.push_back({"the first connection", target.span, ""});
        problem.help = "give the second reset node another state, or make one reset node of both";
        return false;
      }
    }
    return true;
  }

  void add(UnresolvedNode& node, const PortManifest& port, const Owner& owner, std::size_t index,
           const ConnectionSpec& connection) {
    const State& state = (*owner.states)[index];
    ResetTarget reset_target;
    reset_target.name = port.name.value;
    reset_target.object = owner.object;
    reset_target.node = owner.node;
    reset_target.state = index;
    reset_target.space = state.space;
    reset_target.span = connection.to.span;
    if (connection.settings.processor) {
      reset_target.processor =
          make_processor(draft_, *connection.settings.processor, state.space, connection.from.span);
      if (!reset_target.processor) return;
      reset_target.space = reset_target.processor->output;
    }
    const EntitySpec* spec = find_named(draft_.spec.nodes, node.node.name);
    const PartialSpace declared =
        partial_space(port.space, references_of(*node.node.entity, spec->config), diagnostics());
    if (!fits(declared, reset_target.space)) {
      const bool dtype = !declared.dtype || *declared.dtype == reset_target.space.dtype;
      auto& problem =
          diagnostics().error(dtype ? "E0306" : "E0305", connection.to.span,
                              fmt::format("`{}` takes {}, but gets {}", connection.to.value,
                                          describe(declared), reset_target.space.describe()));
      problem.notes.push_back(
          {"it comes from here", connection.from.span, reset_target.space.describe()});
      return;
    }
    node.node.reset_targets.push_back(std::move(reset_target));
  }

  /// A reset node without a request would never run.
  void report_idle(const UnresolvedNode& node) {
    const Entity* entity = node.node.entity;
    if (entity == nullptr || node.node.role != NodeRole::node || !entity->is_reset_node()) return;
    const bool tried = ranges::any_of(draft_.spec.connections, [&](const auto& c) {
      return is_reset_target(c) && parse_port(c.to.value).owner == node.node.name;
    });
    if (tried) return;
    diagnostics()
        .error("E0310", node.node.span, fmt::format("`{}` has no target", node.node.name))
        .help =
        missing_connection(fmt::format("{{from: object.states.name, to: {}.targets.{}}}",
                                       node.node.name, entity->reset_targets.front().name.value));
  }

  UnresolvedGraph& draft_;
};

/// EAGERx's rules for feedthroughs: the message of the same tick, whenever there is one.
void check_feedthrough(const Graph& graph, const GraphNode& node, const Input& input,
                       Diagnostics& diagnostics) {
  const GraphNode& source = graph.nodes[input.source_node];
  if (!(source.rate_hz == node.rate_hz)) {
    auto& problem = diagnostics.error(
        "E0317", input.span,
        fmt::format("`{}` ticks at {} Hz, but what it gets at {} Hz", input.written,
                    node.rate_hz.to_string(), source.rate_hz.to_string()));
    problem.help = "give the reset node the rate of what it passes on";
  }
  if (input.skip || input.window == 0) {
    diagnostics
        .error("E0318", input.span,
               fmt::format("`{}` cannot have {}", input.written,
                           input.skip ? "`skip: true`" : "`window: 0`"))
        .help = "a reset node needs a message to pass on at every tick";
  }
  const Output* output = find_named(node.outputs, input.name);
  if (output->raw.dtype == input.space.dtype && output->raw.shape == input.space.shape) return;
  diagnostics.error(output->raw.dtype == input.space.dtype ? "E0306" : "E0305", input.span,
                    fmt::format("`{}` is {}, but passes on {}", input.written,
                                output->raw.describe(), input.space.describe()));
}

/// Everything that waits for an action, feedthroughs apart; and the task, which is about steps.
void mark_waiting(Graph& graph) {
  std::vector<std::size_t> todo = {Graph::kEnvironment};
  if (graph.task) {
    graph.nodes[graph.task->node].waits_during_reset = true;
    todo.push_back(graph.task->node);
  }
  while (!todo.empty()) {
    const std::size_t source = todo.back();
    todo.pop_back();
    for (std::size_t n = Graph::kEnvironment + 1; n < graph.nodes.size(); ++n) {
      GraphNode& node = graph.nodes[n];
      const bool reads = ranges::any_of(
          node.inputs, [&](const Input& i) { return i.source_node == source && !i.feedthrough; });
      if (!reads || node.waits_during_reset) continue;
      node.waits_during_reset = true;
      todo.push_back(n);
    }
  }
}

/// Whether a reset would wait for this node for ever: the engine for its engine nodes, everybody
/// for reset nodes.
bool is_stuck(const GraphNode& node) {
  const bool synchronised = node.role == NodeRole::engine_node &&
                            ranges::contains(node.inputs, Graph::kEngine, &Input::source_node);
  return node.waits_during_reset && (synchronised || node.is_reset_node());
}

}  // namespace

bool is_reset_target(const ConnectionSpec& connection) {
  return parse_port(connection.to.value).section == "targets";
}

void resolve_reset_targets(UnresolvedGraph& draft) {
  ResetTargetResolver(draft).run();
}

void check_resets(Graph& graph, Diagnostics& diagnostics) {
  if (!graph.has_reset_nodes()) return;
  for (const auto& node : graph.nodes) {
    for (const auto& input : node.inputs) {
      if (input.feedthrough) check_feedthrough(graph, node, input, diagnostics);
    }
  }
  mark_waiting(graph);
  for (const auto& node : graph.nodes) {
    if (!is_stuck(node)) continue;
    const auto input = ranges::find_if(node.inputs, [&](const Input& i) {
      const GraphNode& source = graph.nodes[i.source_node];
      const bool waits = i.source_node == Graph::kEnvironment || source.waits_during_reset;
      return !i.feedthrough && waits && !is_stuck(source);
    });
    if (input == node.inputs.end()) continue;  // follows from another one
    auto& problem = diagnostics.error(
        "E0318", input->span,
        fmt::format("`{}` waits for an action, and during a reset there is none", input->written));
    problem.label = "the reset would never end";
    problem.help = !node.is_reset_node()
                       ? "put a reset node in between: it takes the action as a feedthrough"
                       : "a reset node decides without the agent";
  }
}

}  // namespace eagerx::gen

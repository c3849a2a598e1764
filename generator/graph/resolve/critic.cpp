#include "generator/graph/resolve/critic.hpp"

#include <fmt/format.h>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Names of the states of objects and nodes: "pendulum.mass".
std::vector<CriticInput> states_of(const UnresolvedGraph& draft) {
  std::vector<CriticInput> all;
  const auto add = [&](const std::string& owner, const State& state) {
    if (!state.settable) return;
    all.push_back({owner + "." + state.name, std::nullopt, state.space, state.random.has_value(),
                   state.span});
  };
  for (const Object& object : draft.graph.objects) {
    for (const State& state : object.states) add(object.name, state);
  }
  for (const GraphNode& node : draft.graph.nodes) {
    for (const State& state : node.states) add(node.name, state);
  }
  return all;
}

void report_unknown(UnresolvedGraph& draft, const Spanned<std::string>& name,
                    const std::vector<CriticInput>& states) {
  if (draft.erroneous.contains(parse_port(name.value).owner)) return;
  std::vector<std::string> known;
  for (const auto& input : draft.spec.task->inputs) known.push_back(input.name.value);
  for (const auto& state : states) known.push_back(state.name);
  auto& problem = draft.diagnostics.error(
      "E0307", name.span,
      fmt::format("`{}` is neither an input of the task nor a state", name.value));
  const std::string near = nearest(name.value, known);
  if (!near.empty() || name.value.find('.') == std::string::npos) {
    problem.help = suggestion(name.value, known, "the task has no inputs");
    return;
  }
  problem.help = fmt::format(
      "of a sensor, an output or an action: write `inputs: {{{0}: {1}}}` and `critic: [{0}]`; "
      "states are those under `states:` of an object or a node",
      parse_port(name.value).name, name.value);
}

}  // namespace

/// The spaces of the outputs follow once those of the inputs are known.
void add_critic_outputs(UnresolvedGraph& draft, UnresolvedNode& task) {
  for (const Spanned<std::string>& name : draft.spec.task->critic) {
    if (task.input(name.value) == nullptr) continue;
    UnresolvedOutput output{fmt::format("critic_{}", name.value), name.span, {}, std::nullopt};
    output.declared.like = name.value;
    output.declared.span = output.declared.like_span = name.span;
    if (UnresolvedOutput* const earlier = task.output(output.name)) {
      draft.diagnostics
          .error("E0315", earlier->span, fmt::format("the name `{}` is taken", output.name))
          .notes.push_back({"by what the critic sees", name.span, ""});
      continue;
    }
    task.outputs.push_back(std::move(output));
  }
}

void resolve_critic(UnresolvedGraph& draft) {
  if (!draft.task || draft.graph.nodes.empty()) return;
  const std::vector<CriticInput> states = states_of(draft);
  const GraphNode& node = draft.graph.nodes[*draft.task];
  for (const Spanned<std::string>& name : draft.spec.task->critic) {
    const auto input = ranges::find(node.inputs, name.value, &Input::name);
    const auto state = ranges::find(states, name.value, &CriticInput::name);
    if (input != node.inputs.end()) {
      const auto place = static_cast<std::size_t>(input - node.inputs.begin());
      draft.graph.task->critic.push_back({name.value, place, input->space, true, name.span});
    } else if (state != states.end()) {
      draft.graph.task->critic.push_back(
          {state->name, std::nullopt, state->space, state->sampled, name.span});
    } else {
      report_unknown(draft, name, states);
    }
  }
}

}  // namespace eagerx::gen

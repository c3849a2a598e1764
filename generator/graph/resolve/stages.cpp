#include "generator/graph/resolve/stages.hpp"

#include <fmt/format.h>

#include "generator/graph/resolve/states.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

class StagesResolver {
 public:
  explicit StagesResolver(UnresolvedGraph& draft) : draft_(draft), task_(*draft.graph.task) {
    const Graph& graph = draft.graph;
    for (std::size_t i = 0; i < graph.objects.size(); ++i)
      add(graph.objects[i].name, graph.objects[i].states, i, 0);
    for (std::size_t n = 0; n < graph.nodes.size(); ++n)
      add(graph.nodes[n].name, graph.nodes[n].states, std::nullopt, n);
  }

  void run() {
    for (const StageSpec& spec : draft_.spec.task->stages) {
      Stage stage;
      stage.name = spec.name.value;
      stage.span = spec.name.span;
      stage.success = spec.success;
      stage.mean_return = spec.mean_return;
      for (const StageStateSpec& state : spec.states) add_state(state, stage);
      weigh(spec, stage);
      check(spec);
      task_.stages.push_back(std::move(stage));
    }
  }

 private:
  struct Known {
    std::string name;
    std::optional<std::size_t> object;
    std::size_t node, state;
    const State* what;
  };

  void add(const std::string& owner, const std::vector<State>& states,
           std::optional<std::size_t> object, std::size_t node) {
    for (std::size_t s = 0; s < states.size(); ++s) {
      if (states[s].settable)
        known_.push_back({owner + "." + states[s].name, object, node, s, &states[s]});
    }
  }

  void add_state(const StageStateSpec& spec, Stage& stage) {
    const auto found = ranges::find(known_, spec.state.value, &Known::name);
    if (found == known_.end()) {
      report_unknown(spec.state);
    } else if (!found->what->random) {
      report_kept(spec.state, *found->what);
    } else if (auto random = read_random(spec.state.value, found->what->space, spec.random,
                                         draft_.diagnostics)) {
      stage.states.push_back(
          {found->name, found->object, found->node, found->state, std::move(*random)});
    }
  }

  void report_unknown(const Spanned<std::string>& name) {
    if (draft_.erroneous.contains(parse_port(name.value).owner)) return;
    auto& problem = draft_.diagnostics.error(
        "E0307", name.span, fmt::format("the graph has no state `{}`", name.value));
    problem.help = suggestion(name.value, names_of_states(), "no state is under `states:`");
  }
  [[nodiscard]] std::vector<std::string> names_of_states() const {
    std::vector<std::string> names;
    for (const Known& each : known_) names.push_back(each.name);
    return names;
  }

  /// Nothing would sample it again once the stage is over.
  void report_kept(const Spanned<std::string>& name, const State& state) {
    auto& problem = draft_.diagnostics.error(
        "E0352", name.span, fmt::format("the graph does not sample `{}`", name.value));
    problem.notes.push_back({"it keeps its value here", state.span, ""});
    problem.help = fmt::format(
        "write its value in the graph, which is that of the last part of a training: "
        "`{}: {{value: …}}`",
        state.name);
  }

  void weigh(const StageSpec& spec, Stage& stage) {
    for (const TaskExpression& term : task_.terms) stage.weights.push_back(term.weight);
    for (const auto& [name, weight] : spec.weights) {
      const auto term = ranges::find(task_.terms, name.value, &TaskExpression::name);
      if (term == task_.terms.end()) {
        draft_.diagnostics
            .error("E0307", name.span, fmt::format("the reward has no term `{}`", name.value))
            .help = suggestion(name.value, names_of(task_.terms), "the reward has no terms");
      } else if (term->weight == 0.0) {
        report_no_weight(name, *term);
      } else {
        stage.weights[static_cast<std::size_t>(term - task_.terms.begin())] = weight;
      }
    }
  }

  /// Programs give terms with their weights, and what is multiplied by 0 is lost.
  void report_no_weight(const Spanned<std::string>& name, const TaskExpression& term) {
    auto& problem = draft_.diagnostics.error(
        "E0352", name.span,
        fmt::format("no stage can weigh `{}`: its weight in the graph is 0", name.value));
    problem.notes.push_back({"this term", term.span, ""});
    problem.help = "give it a small one there, such as 1e-6";
  }

  void check(const StageSpec& spec) {
    if (spec.is_as_written) {
      draft_.diagnostics
          .error("E0352", spec.name.span,
                 fmt::format("the stage `{}` is the graph as it is written", spec.name.value))
          .help = "give it `states:` or `weights:`, or leave it out: that is what comes last";
    }
    if (spec.success && draft_.spec.task->success.empty()) {
      draft_.diagnostics
          .error("E0352", spec.until, "a stage waits for success, and the task does not say it")
          .help = "write `success:`, or wait for a return: `until: {return: …}`";
    }
  }

  UnresolvedGraph& draft_;
  Task& task_;
  std::vector<Known> known_;
};

}  // namespace

std::string Random::describe() const {
  const auto list = [](const std::vector<double>& numbers) {
    return fmt::format("[{}]", join(numbers, ", "));
  };
  switch (kind) {
    case RandomSpec::Kind::value:
      return list(first);
    case RandomSpec::Kind::uniform:
      return fmt::format("uniform from {} to {}", list(first), list(second));
    case RandomSpec::Kind::normal:
      return fmt::format("normal with mean {}, deviation {}", list(first), list(second));
    case RandomSpec::Kind::log_uniform:
      return fmt::format("log-uniform from {} to {}", list(first), list(second));
    case RandomSpec::Kind::choice:
      break;
  }
  std::vector<std::string> texts;
  for (const std::vector<double>& choice : choices) texts.push_back(list(choice));
  return fmt::format("one of [{}]", join(texts, ", "));
}

std::string Task::describe(const Stage& stage) const {
  std::vector<std::string> parts;
  for (const StageState& state : stage.states)
    parts.push_back(fmt::format("{} {}", state.name, state.random.describe()));
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (stage.weights[i] != terms[i].weight)
      parts.push_back(fmt::format("{} times {}", terms[i].name, stage.weights[i]));
  }
  if (stage.success) parts.push_back(fmt::format("until success {}", *stage.success));
  if (stage.mean_return) parts.push_back(fmt::format("until return {}", *stage.mean_return));
  return fmt::format("{}", join(parts, "; "));
}

void resolve_stages(UnresolvedGraph& draft) {
  if (!draft.task || draft.graph.nodes.empty() || draft.spec.task->stages.empty()) return;
  StagesResolver(draft).run();
}

}  // namespace eagerx::gen

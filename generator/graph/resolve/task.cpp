#include "generator/graph/resolve/task.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/graph/resolve/critic.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

// Steps are counted in Real; up to here a float has every whole number.
constexpr std::int64_t kMostSteps = std::int64_t{1} << 24U;

PortManifest port_of(const Spanned<std::string>& name) {
  PortManifest port;
  port.name = name;
  return port;
}

/// The class is generated along with the program.
std::shared_ptr<const Entity> entity_of(const GraphSpec& spec) {
  Entity entity;
  entity.kind = EntityKind::node;
  entity.id = {"Task", spec.task->span};
  entity.summary = "Reward and end of an episode.";
  entity.path = spec.path;
  entity.cpp = {fmt::format("graphs::{}::Task", spec.name.value),
                fmt::format("{}/task.hpp", spec.name.value)};
  entity.vectorized = always();
  for (const auto& input : spec.task->inputs) entity.inputs.push_back(port_of(input.name));
  return std::make_shared<const Entity>(std::move(entity));
}

UnresolvedOutput output_of(const std::string& name, Dtype dtype, Span span) {
  UnresolvedOutput output{name, span, {}, std::nullopt};
  output.declared.dtype = dtype;
  output.declared.shape.emplace();
  output.declared.span = span;
  return output;
}

/// A term's channel stands next to those of the whole.
void check_term_name(const Spanned<std::string>& name, const UnresolvedNode& node,
                     Diagnostics& diagnostics) {
  if (!ranges::contains(node.outputs, name.value, &UnresolvedOutput::name)) return;
  diagnostics.error("E0315", name.span, fmt::format("the name `{}` is taken", name.value)).help =
      "every task already has reward, terminated, truncated, success: choose another name";
}

/// Nodes that wait for the environment's action of the same tick.
std::vector<bool> nodes_behind_actions(const UnresolvedGraph& draft) {
  std::vector<bool> behind(draft.nodes.size(), false);
  std::vector<std::vector<std::size_t>> readers(draft.nodes.size());
  for (std::size_t n = 0; n < draft.nodes.size(); ++n) {
    for (const auto& input : draft.nodes[n].inputs) {
      if (n != draft.task && input.edge && !skips(input.settings))
        readers[input.edge->node].push_back(n);
    }
  }
  std::vector<std::size_t> todo = {Graph::kEnvironment};
  while (!todo.empty()) {
    const std::size_t node = todo.back();
    todo.pop_back();
    if (behind[node]) continue;
    behind[node] = true;
    todo.insert(todo.end(), readers[node].begin(), readers[node].end());
  }
  return behind;
}

std::vector<ExpressionVariable> variables_of(const GraphNode& node) {
  std::vector<ExpressionVariable> variables;
  for (const auto& input : node.inputs) {
    variables.push_back({input.name, input.space.dtype == Dtype::boolean, input.space.shape});
  }
  return variables;
}

class TaskResolver {
 public:
  explicit TaskResolver(UnresolvedGraph& draft)
      : draft_(draft), variables_(variables_of(draft.graph.nodes[*draft.task])) {}

  void run() {
    const TaskSpec& spec = *draft_.spec.task;
    Task& task = *draft_.graph.task;
    for (const TermSpec& term : spec.reward) {
      add(task.terms, term.name, term.value, ExpressionType::number, term.weight);
    }
    add_conditions(task.terminated, spec.terminated);
    add_conditions(task.truncated, spec.truncated);
    add_conditions(task.success, spec.success);
    if (spec.after_s) task.after = steps_of(*spec.after_s, "after");
    if (spec.over_last_s) task.over_last = steps_of(*spec.over_last_s, "over_last");
    check_success(spec, task);
  }

 private:
  void add(std::vector<TaskExpression>& to, const Spanned<std::string>& name, const YamlValue& text,
           ExpressionType type, double weight = 1.0) {
    const auto help = [this](const std::string& unknown) { return help_with(unknown); };
    auto value = read_typed_expression(text, variables_, type, help, draft_.diagnostics);
    if (value) to.push_back({name.value, text.text, std::move(*value), weight, name.span});
  }

  /// The correct form of a port in an expression, which knows the names under `inputs:` only. Empty
  /// if `unknown` is none.
  [[nodiscard]] std::string help_with(const std::string& unknown) const {
    const auto is_meant = [&](const std::string& port) {
      return port == unknown || parse_port(port).name == unknown;
    };
    for (const TaskInputSpec& input : draft_.spec.task->inputs) {
      if (is_meant(input.from.value))
        return fmt::format("`{}` is `{}` here", input.from.value, input.name.value);
    }
    for (const ConnectionSpec& connection : draft_.spec.connections) {
      if (parse_port(connection.from.value).name == unknown)
        return fmt::format("give it a name under `inputs:`: `{}: {}`", unknown,
                           connection.from.value);
    }
    if (unknown.find('.') == std::string::npos) return {};
    return fmt::format("give it a name under `inputs:`: `x: {}`", unknown);
  }

  void add_conditions(std::vector<TaskExpression>& to,
                      const std::vector<TaskConditionSpec>& conditions) {
    for (const auto& condition : conditions)
      add(to, condition.name, condition.that, ExpressionType::condition);
  }

  /// The first step that is not before the time.
  std::uint64_t steps_of(const Spanned<Rational>& time_s, const char* key) {
    const Rational steps = time_s.value * draft_.spec.rate.value;
    if (!steps.overflowed() && steps <= Rational(kMostSteps))
      return static_cast<std::uint64_t>(std::max<std::int64_t>(steps.ceil(), 1));
    draft_.diagnostics.error("E0323", time_s.span, fmt::format("`{}` is out of range", key)).label =
        fmt::format("these are more than {} steps", kMostSteps);
    return 1;
  }

  /// An episode that is always cut off before cannot succeed.
  void check_success(const TaskSpec& spec, const Task& task) {
    if (!spec.after_s || !spec.over_last_s || task.over_last <= task.after) return;
    auto& problem =
        draft_.diagnostics.error("E0339", spec.over_last_s->span,
                                 "`over_last` is longer than an episode: there is never a success");
    problem.notes.push_back({"episodes are cut off here", spec.after_s->span, ""});
  }

  UnresolvedGraph& draft_;
  std::vector<ExpressionVariable> variables_;
};

}  // namespace

void add_task(UnresolvedGraph& draft) {
  if (!draft.spec.task) return;
  const TaskSpec& spec = *draft.spec.task;
  Task& task = draft.graph.task.emplace();
  task.node = draft.nodes.size();
  task.span = spec.span;
  task.entity = entity_of(draft.spec);
  draft.task = task.node;
  UnresolvedNode node;
  node.node.name = kTask;
  node.node.role = NodeRole::node;
  node.node.entity = task.entity.get();
  node.node.rate_hz = draft.spec.rate.value;
  node.node.span = spec.span;
  for (const auto& input : spec.inputs) {
    UnresolvedInput port;
    port.name = input.name.value;
    port.written = fmt::format("{}.{}", kTask, port.name);
    port.span = input.name.span;
    node.inputs.push_back(std::move(port));
  }
  const Dtype real = draft.graph.double_precision ? Dtype::float64 : Dtype::float32;
  node.outputs.push_back(output_of("reward", real, spec.span));
  for (const char* name : {"terminated", "truncated", "success"})
    node.outputs.push_back(output_of(name, Dtype::boolean, spec.span));
  for (const TermSpec& term : spec.reward) {
    check_term_name(term.name, node, draft.diagnostics);
    node.outputs.push_back(output_of(term.name.value, real, term.name.span));
  }
  add_critic_outputs(draft, node);
  draft.nodes.push_back(std::move(node));
}

void let_task_skip(UnresolvedGraph& draft) {
  if (!draft.task) return;
  const std::vector<bool> behind = nodes_behind_actions(draft);
  for (auto& input : draft.nodes[*draft.task].inputs) {
    if (input.edge && behind[input.edge->node]) input.settings.skip = {true, input.span};
  }
}

void resolve_task(UnresolvedGraph& draft) {
  if (draft.task && !draft.graph.nodes.empty()) TaskResolver(draft).run();
}

}  // namespace eagerx::gen

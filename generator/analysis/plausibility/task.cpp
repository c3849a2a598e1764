// Parts of a task that have no effect.
#include <fmt/format.h>

#include "generator/analysis/plausibility/plausibility.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kCode = "W0110";

void check_terms(const Task& task, Diagnostics& diagnostics) {
  for (const TaskExpression& term : task.terms) {
    if (term.weight == 0.0) {
      diagnostics.warning(kCode, term.span, fmt::format("`{}` has the weight 0", term.name)).help =
          "leave it out, or give it a weight";
    } else if (task.terminated.empty() && !varies(term.value)) {
      // Where episodes end early, each further step may well be worth the same.
      auto& problem = diagnostics.warning(
          kCode, term.span, fmt::format("`{}` is the same after every step", term.name));
      problem.label = "it makes no action better than another";
      problem.help = "name an input in it, or leave it out";
    }
  }
}

void check_conditions(const std::vector<TaskExpression>& conditions, Diagnostics& diagnostics) {
  for (const TaskExpression& condition : conditions) {
    if (varies(condition.value)) continue;
    diagnostics
        .warning(kCode, condition.span,
                 fmt::format("`{}` is the same after every step", condition.name))
        .help = "name an input in it, or leave it out";
  }
}

void check_inputs(const Graph& graph, Diagnostics& diagnostics) {
  const Task& task = *graph.task;
  const GraphNode& node = graph.nodes[task.node];
  std::vector<bool> used(node.inputs.size());
  for (const auto* expressions : {&task.terms, &task.terminated, &task.truncated, &task.success}) {
    for (const TaskExpression& expression : *expressions) {
      for_each_part(expression.value, [&](const TypedExpression& part) {
        if (part.op == TypedExpression::Op::variable || part.op == TypedExpression::Op::before)
          used[part.variable] = true;
      });
    }
  }
  for (const CriticInput& seen : task.critic) {
    if (seen.input) used[*seen.input] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) continue;
    diagnostics
        .warning(kCode, node.inputs[i].span,
                 fmt::format("no expression of the task reads `{}`", node.inputs[i].name))
        .help = "leave it out";
  }
}

void check_critic(const std::vector<CriticInput>& critic, Diagnostics& diagnostics) {
  for (const CriticInput& seen : critic) {
    if (seen.sampled) continue;
    auto& problem = diagnostics.warning(
        kCode, seen.span, fmt::format("`{}` is not sampled: the critic always sees 0", seen.name));
    problem.label = "unless the program that trains sets it";
    problem.help = "sample it, as with `states: {mass: uniform}` of its object, or leave it out";
  }
}

}  // namespace

void check_task(const Graph& graph, Diagnostics& diagnostics) {
  if (!graph.task) return;
  check_terms(*graph.task, diagnostics);
  check_conditions(graph.task->terminated, diagnostics);
  check_conditions(graph.task->truncated, diagnostics);
  check_conditions(graph.task->success, diagnostics);
  check_inputs(graph, diagnostics);
  check_critic(graph.task->critic, diagnostics);
}

}  // namespace eagerx::gen

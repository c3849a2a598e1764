// task.hpp: reward, end and success of a step; and references to the task in other files.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/backend/emit/expression_text.hpp"
#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/types.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

/// Inputs that a task's expressions read.
struct Used {
  std::vector<bool> variable, before, by_critic;  // by input
  bool time = false;
};

Used used_by(const Task& task, std::size_t inputs) {
  Used used{std::vector<bool>(inputs), std::vector<bool>(inputs), std::vector<bool>(inputs)};
  for (const CriticInput& seen : task.critic) {
    if (seen.input) used.by_critic[*seen.input] = true;
  }
  for (const auto* expressions : {&task.terms, &task.terminated, &task.truncated, &task.success}) {
    for (const TaskExpression& expression : *expressions) {
      for_each_part(expression.value, [&](const TypedExpression& part) {
        if (part.op == TypedExpression::Op::variable) used.variable[part.variable] = true;
        if (part.op == TypedExpression::Op::before) used.before[part.variable] = true;
        used.time = used.time || part.op == TypedExpression::Op::time;
      });
    }
  }
  return used;
}

class TaskView {
 public:
  explicit TaskView(const Plan& plan)
      : graph_(*plan.graph),
        task_(*graph_.task),
        node_(graph_.nodes[task_.node]),
        used_(used_by(task_, node_.inputs.size())) {
    for (const char* taken : {"in", "out", "tick", "i", "begin", "Real", "Io"})
      locals_.unique(taken);
  }

  View make() {
    add_inputs();
    add_time();
    ExpressionWriter writer(variables_, "time", locals_);
    add_terms(writer);
    view_.set("terminated", conditions(writer, task_.terminated, "terminations"));
    std::string truncated = conditions(writer, task_.truncated, "truncations");
    if (task_.after > 0) {
      const std::string over = "steps_ >= " + real_literal(static_cast<double>(task_.after));
      truncated = task_.truncated.empty() ? over : over + " || " + truncated;
    }
    view_.set("truncated", truncated);
    view_.set("success", conditions(writer, task_.success, "successes"));
    view_.set("holds", !task_.success.empty() && task_.over_last > 1);
    view_.set("over_last", real_literal(static_cast<double>(task_.over_last)));
    return std::move(view_);
  }

 private:
  bool is_real(const Input& input) const {
    return input.space.dtype == (graph_.double_precision ? Dtype::float64 : Dtype::float32);
  }

  /// Locals for what a callback sees, and members for what it saw a step before.
  void add_inputs() {
    View locals = list(), members = list();
    bool first = false;
    for (std::size_t i = 0; i < node_.inputs.size(); ++i) {
      const Input& input = node_.inputs[i];
      const bool one = input.space.shape.empty();
      VariableText variable;
      if (used_.variable[i] || used_.before[i]) {
        variable.name = locals_.unique(input.name);
        variable.before = locals_.unique("before_" + input.name) + "_";
        variable.casts = !is_real(input);
        locals.push_back(local_view(input, variable, one));
      }
      if (used_.before[i]) {
        View member = local_view(input, variable, one);
        member.set("member", variable.before);
        member.set("type",
                   one ? "Real"
                       : fmt::format("typename decltype(Io::Inputs::{})::value_type", input.name));
        member.set("has_first", !input.skip);
        members.push_back(member);
        first = first || !input.skip;
      }
      variables_.push_back(std::move(variable));
    }
    // By the clock, the first action may come after tick 0.
    std::string first_tick = "tick.n == 0";
    for (std::size_t i = 0; graph_.asynchronous && i < node_.inputs.size(); ++i) {
      if (node_.inputs[i].skip && (used_.variable[i] || used_.before[i] || used_.by_critic[i]))
        first_tick += fmt::format(" || in.{}.empty()", node_.inputs[i].name);
    }
    View critic = list();
    for (const CriticInput& seen : task_.critic) {
      if (!seen.input) continue;
      const Input& input = node_.inputs[*seen.input];
      View item = object();
      item.set("input", input.name);
      item.set("has_first", !input.skip);
      critic.push_back(item);
      first = first || !input.skip;
    }
    view_.set("is_first", first_tick);
    view_.set("uses_inputs", locals.is_non_empty_list() || critic.is_non_empty_list());
    view_.set("begins_with_inputs", first);
    view_["critic"] = std::move(critic);
    view_["locals"] = std::move(locals);
    view_["members"] = std::move(members);
  }

  View local_view(const Input& input, const VariableText& variable, bool one) const {
    const std::string back = fmt::format("in.{}.back()", input.name);
    const bool truth = input.space.dtype == Dtype::boolean;
    View local = object();
    local.set("local", variable.name);
    local.set("type", !one ? "const auto&" : truth ? "const auto" : "const Real");
    local.set("value",
              one && !truth && variable.casts ? fmt::format("static_cast<Real>({})", back) : back);
    return local;
  }

  void add_time() {
    view_.set("uses_time", used_.time);
    view_.set("counts_steps", used_.time || task_.after > 0);
    if (used_.time) locals_.unique("time");
    const Rational& rate = node_.rate_hz;
    const std::string steps =
        rate.den() == 1 ? "steps_" : "steps_ * " + real_literal(static_cast<double>(rate.den()));
    view_.set("time", steps + " / " + real_literal(static_cast<double>(rate.num())));
  }

  View statement(const TaskExpression& expression, const std::vector<std::string>& lines) const {
    View view = object();
    view.set("name", expression.name);
    view.set("text", expression.text);
    view["lines"] = lines_view(lines);
    return view;
  }

  void add_terms(ExpressionWriter& writer) {
    View terms = list();
    std::vector<std::string> sum;
    for (const TaskExpression& term : task_.terms) {
      std::vector<std::string> lines;
      const std::string value = writer.write_weighted(term.value, term.weight, lines);
      View view = statement(term, lines);
      view.set("weight", text_or_false(term.weight == 1.0 ? "" : fmt::format("{}", term.weight)));
      view.set("value", value);
      terms.push_back(view);
      sum.push_back("out." + term.name);
    }
    view_.set("reward", fmt::format("{}", join(sum, " + ")));
    view_["terms"] = std::move(terms);
  }

  /// A local for each; the expression that joins them.
  std::string conditions(ExpressionWriter& writer, const std::vector<TaskExpression>& conditions,
                         const char* key) {
    View views = list();
    std::vector<std::string> locals;
    for (const TaskExpression& condition : conditions) {
      std::vector<std::string> lines;
      const std::string value = writer.write(condition.value, lines);
      locals.push_back(locals_.unique(condition.name));
      View view = statement(condition, lines);
      view.set("local", locals.back());
      view.set("value", value);
      views.push_back(view);
    }
    view_[key] = std::move(views);
    if (locals.empty()) return "false";
    const bool all = &conditions == &task_.success;
    return fmt::format("{}", join(locals, all ? " && " : " || "));
  }

  const Graph& graph_;
  const Task& task_;
  const GraphNode& node_;
  Used used_;
  Names locals_;
  std::vector<VariableText> variables_;
  View view_ = object();
};

View names_view(const std::vector<TaskExpression>& expressions) {
  std::vector<std::string> names;
  names.reserve(expressions.size());
  for (const auto& expression : expressions) names.push_back(cpp_string(expression.name));
  View view = object();
  view.set("names", joined(names));
  return view;
}

/// Inputs of a training's critic: messages of the outcome, and names of states.
struct CriticView {
  std::uint64_t numbers = 0;  // of the messages
  View messages = list();
  View states = View(false);
};

CriticView seen_by_critic(const Plan& plan, const ProgramNames& names) {
  CriticView seen;
  std::vector<std::string> states;
  for (const CriticInput& each : plan.graph->task->critic) {
    if (!each.input) {
      states.push_back(cpp_string(each.name));
      continue;
    }
    View item = object();
    item.set("name", each.name);
    item.set("type", names.message(each.space));
    item.set("space", each.space.describe());
    seen.messages.push_back(item);
    seen.numbers += each.space.size();
  }
  if (states.empty()) return seen;
  seen.states = object();
  seen.states.set("names", joined(states));
  return seen;
}

}  // namespace

View task_view(const Plan& plan) {
  return TaskView(plan).make();
}

View outcome_view(const Plan& plan, const ProgramNames& names) {
  const auto& task = plan.graph->task;
  if (!task || !names.runs(task->node)) return View(false);
  View view = object();
  view.set("real", names.real());
  view.set("truth", std::string(element_type(Dtype::boolean, names.numbers)));
  view.set("count", fmt::format("{}", task->terms.size()));
  view.set("steps", fmt::format("{}", task->after));
  view["term_names"] = names_view(task->terms);
  view["termination_names"] = task->terminated.empty() ? View(false) : names_view(task->terminated);
  view["success_names"] = task->success.empty() ? View(false) : names_view(task->success);
  const std::string seq = names.nodes[task->node].sent.empty()
                              ? names.seq_of(task->node)
                              : names.nodes[task->node].sent + ".count() - 1";
  std::vector<std::string> terms, places;
  for (const std::size_t ring : plan.nodes[task->node].rings)
    places.push_back(ring_place(plan, names, ring, seq));
  const auto first_term = places.begin() + Task::term;
  const auto first_seen = first_term + static_cast<std::ptrdiff_t>(task->terms.size());
  terms.assign(first_term, first_seen);
  const std::array<const char*, Task::term> names_of_outputs = {"reward", "terminated", "truncated",
                                                                "success"};
  std::vector<FieldValue> values;
  for (std::size_t i = 0; i < Task::term; ++i) values.push_back({names_of_outputs[i], places[i]});
  values.push_back({"terms", braced({braced(terms)})});
  auto place = first_seen;
  for (const CriticInput& each : task->critic) {
    if (each.input) values.push_back({"critic_" + each.name, *place++});
  }
  CriticView seen = seen_by_critic(plan, names);
  view.set("seen", fmt::format("{}", seen.numbers));
  view.set("has_critic", seen.messages.is_non_empty_list());
  view["critic"] = std::move(seen.messages);
  view["critic_states"] = std::move(seen.states);
  view.set("values", designated(values));
  View fields = list();
  for (std::size_t i = 0; i < task->terms.size(); ++i) {
    View field = object();
    field.set("field", task->terms[i].name);
    field.set("index", fmt::format("{}", i));
    fields.push_back(field);
  }
  view["terms"] = std::move(fields);
  // By the clock, the first message of an episode may come late: until then there is none.
  View stale = list();
  for (std::size_t o = 0; plan.graph->asynchronous && o < plan.nodes[task->node].rings.size();
       ++o) {
    View ring = object();
    ring.set("member", names.rings[plan.nodes[task->node].rings[o]].expression());
    stale.push_back(ring);
  }
  view["stale"] = std::move(stale);
  return view;
}

}  // namespace eagerx::gen

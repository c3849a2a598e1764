// Inputs and results of a graph's task.
#include <fmt/format.h>

#include "generator/analysis/info/info.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

std::string weighted(const TaskExpression& term) {
  return term.weight == 1.0 ? term.text : fmt::format("{} * ({})", term.weight, term.text);
}

std::string conditions_text(const char* what, const std::vector<TaskExpression>& conditions) {
  std::string text;
  for (const TaskExpression& condition : conditions) {
    text += fmt::format("  {:<11} {}: {}\n", what, condition.name, condition.text);
    what = "";
  }
  return text;
}

std::string in_seconds(std::uint64_t steps, const Graph& graph) {
  const Rational seconds = Rational(static_cast<std::int64_t>(steps)) / graph.environment().rate_hz;
  return fmt::format("{}, {} s", counted(steps, "step"), seconds.to_string());
}

Json conditions_json(const std::vector<TaskExpression>& conditions) {
  Json json = Json::object();
  for (const TaskExpression& condition : conditions) json[condition.name] = condition.text;
  return json;
}

}  // namespace

std::string task_text(const Graph& graph) {
  if (!graph.task) return {};
  const Task& task = *graph.task;
  std::string text = "\ntask\n";
  const char* what = "sees";
  for (const Input& input : graph.nodes[task.node].inputs) {
    text += fmt::format("  {:<11} {}: {}{}{}\n", what, input.name, name_of_source(graph, input),
                        input.processor ? ", " + input.processor->names() : "",
                        input.skip ? ", of the step that ends" : "");
    what = "";
  }
  what = "reward";
  for (const TaskExpression& term : task.terms) {
    text += fmt::format("  {:<11} {}: {}\n", what, term.name, weighted(term));
    what = "";
  }
  text += conditions_text("terminated", task.terminated);
  text += conditions_text("truncated", task.truncated);
  if (task.after > 0)
    text += fmt::format("  {:<11} after {}\n", task.truncated.empty() ? "truncated" : "",
                        in_seconds(task.after, graph));
  text += conditions_text("success", task.success);
  if (!task.success.empty())
    text += fmt::format("  {:<11} over the last {}\n", "", in_seconds(task.over_last, graph));
  what = "noise";
  for (const ObservationNoise& noise : task.noise) {
    text += fmt::format("  {:<11} {}: {}{}\n", what, noise.observation, noise.text,
                        noise.node ? "" : " in simulation; here the sensors are real");
    what = "";
  }
  what = "critic sees";
  for (const CriticInput& seen : task.critic) {
    text += fmt::format("  {:<11} {}: {}\n", what, seen.name, seen.space.describe());
    what = "";
  }
  what = "stages";
  for (const Stage& stage : task.stages) {
    text += fmt::format("  {:<11} {}: {}\n", what, stage.name, task.describe(stage));
    what = "";
  }
  return text;
}

Json task_json(const Graph& graph) {
  const Task& task = *graph.task;
  Json json;
  json["inputs"] = Json::object();
  for (const Input& input : graph.nodes[task.node].inputs)
    json["inputs"][input.name] = name_of_source(graph, input);
  json["reward"] = Json::object();
  for (const TaskExpression& term : task.terms)
    json["reward"][term.name] = Json{{"value", term.text}, {"weight", term.weight}};
  json["terminated"] = conditions_json(task.terminated);
  json["truncated"] = conditions_json(task.truncated);
  json["success"] = conditions_json(task.success);
  json["noise"] = Json::object();
  for (const ObservationNoise& noise : task.noise) json["noise"][noise.observation] = noise.text;
  json["critic"] = Json::list();
  for (const CriticInput& seen : task.critic) json["critic"].push_back(seen.name);
  json["stages"] = Json::list();
  for (const Stage& stage : task.stages)
    json["stages"].push_back(Json{{"name", stage.name}, {"what", task.describe(stage)}});
  json["episode_steps"] = task.after;
  json["success_steps"] = task.over_last;
  return json;
}

}  // namespace eagerx::gen

#include "generator/analysis/compare/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

std::string text_of(const ConfigValue& value) {
  return std::visit(
      [](const auto& held) -> std::string {
        using Held = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::shared_ptr<const ModelUse>>)
          return held->object->id.value;
        else if constexpr (requires { join(held, ", "); })
          return fmt::format("[{}]", join(held, ", "));
        else
          return fmt::format("{}", held);
      },
      value.value);
}

std::string text_of(const std::optional<Random>& random) {
  return random ? random->describe() : "set by the program's interface";
}

std::string text_of(const Processor& processor) {
  std::vector<std::string> stages;
  for (const Processor* stage : processor.stages()) {
    std::vector<std::string> values;
    for (const ConfigValue& value : stage->config)
      values.push_back(fmt::format("{}: {}", value.parameter->name.value, text_of(value)));
    stages.push_back(fmt::format("{}({})", stage->entity->id.value, join(values, ", ")));
  }
  return fmt::format("{}", join(stages, ", "));
}

class FactCollector {
 public:
  explicit FactCollector(const PlanInfo& report) : report_(report), graph_(*report.plan->graph) {}

  GraphFacts all() {
    facts_["graph.rate"] = graph_.environment().rate_hz.to_string();
    facts_["graph.real"] = graph_.double_precision ? "double" : "float";
    facts_["agent"] = agent();
    if (graph_.has_engine()) node("engine", graph_.engine());
    for (const Object& each : graph_.objects) object(each);
    for (const GraphNode& each : graph_.nodes) {
      if (each.role == NodeRole::node && each.entity != nullptr && !is_added(each))
        node("nodes." + each.name, each);
      connections(each);
    }
    for (const Output& action : graph_.environment().outputs)
      facts_["actions." + action.name] = action.space.describe();
    for (const Input& observation : graph_.environment().inputs)
      facts_[observation.written] = observation.space.describe();
    for (const DataAge& age : report_.ages)
      facts_[fmt::format("age of {} at {}", age.from, age.to)] =
          fmt::format("{} s", age.newest_s.to_string());
    if (graph_.task) task(*graph_.task);
    safety();
    return std::move(facts_);
  }

 private:
  /// Nodes that the generator adds have their own facts.
  [[nodiscard]] bool is_added(const GraphNode& node) const {
    return (graph_.task && &graph_.nodes[graph_.task->node] == &node) ||
           (graph_.render && &graph_.nodes[graph_.render->node] == &node);
  }

  [[nodiscard]] std::string agent() const {
    switch (graph_.agent.kind) {
      case AgentSpec::Kind::zero:
        return "zero";
      case AgentSpec::Kind::random:
        return "random";
      default:
        return graph_.agent.file;
    }
  }

  void config(const std::string& owner, const Config& config) {
    for (const ConfigValue& value : config)
      facts_[fmt::format("{}.config.{}", owner, value.parameter->name.value)] = text_of(value);
  }

  void states(const std::string& owner, const std::vector<State>& states) {
    for (const State& state : states)
      if (state.settable)
        facts_[fmt::format("{}.states.{}", owner, state.name)] = text_of(state.random);
  }

  void node(const std::string& owner, const GraphNode& node) {
    facts_[owner] = node.entity->id.value;
    facts_[owner + ".rate"] = node.rate_hz.to_string();
    config(owner, node.config);
    states(owner, node.states);
    for (const Output& output : node.outputs) {
      std::string text = output.space.describe();
      if (output.processor) text += ", " + text_of(*output.processor);
      facts_[fmt::format("{}.outputs.{}", owner, output.name)] = text;
    }
  }

  void object(const Object& object) {
    const std::string owner = "objects." + object.name;
    facts_[owner] = object.entity->id.value;
    config(owner, object.config);
    states(owner, object.states);
  }

  /// Those of the graph, not those within an object.
  void connections(const GraphNode& node) {
    for (const Input& input : node.inputs) {
      if (node.role == NodeRole::engine_node && !input.actuator) continue;
      if (node.role == NodeRole::engine) continue;
      std::string text = name_of_source(graph_, input);
      if (input.window != 1) text += fmt::format(", window {}", input.window);
      if (input.delay_s != Rational())
        text += fmt::format(", delay {} s", input.delay_s.to_string());
      if (input.random_delay) text += ", delay " + text_of(input.random_delay);
      if (input.skip) text += ", skip";
      if (input.processor) text += ", " + text_of(*input.processor);
      facts_["connection to " + input.written] = text;
    }
  }

  void task(const Task& task) {
    const auto add = [&](const char* key, const std::vector<TaskExpression>& expressions) {
      for (const TaskExpression& each : expressions)
        facts_[fmt::format("task.{}.{}", key, each.name)] =
            each.weight == 1.0 ? each.text : fmt::format("{} * ({})", each.weight, each.text);
    };
    add("reward", task.terms);
    add("terminated", task.terminated);
    add("truncated", task.truncated);
    add("success", task.success);
    for (const ObservationNoise& each : task.noise)
      facts_["task.noise." + each.observation] = each.text;
    for (const CriticInput& each : task.critic) facts_["task.critic." + each.name] = "seen";
    for (std::size_t i = 0; i < task.stages.size(); ++i)
      facts_["task.stages." + task.stages[i].name] =
          fmt::format("number {}: {}", i + 1, task.describe(task.stages[i]));
    if (task.after > 0) facts_["task.truncated.after"] = fmt::format("{} steps", task.after);
  }

  void safety() {
    const Safety& safety = graph_.safety;
    if (!safety.declared) return;
    facts_["safety"] =
        fmt::format("late {}, missed {}, recover {}, max_lateness {} s, {}, {}", safety.late,
                    safety.missed, safety.recover, safety.max_lateness_s.to_string(),
                    safety.clips ? "clip" : "safe", safety.holds ? "hold" : "safe");
    for (std::size_t a = 0; a < safety.actions.size(); ++a)
      facts_["safety.actions." + graph_.environment().outputs[a].name] =
          fmt::format("[{}]", join(safety.actions[a], ", "));
  }

  const PlanInfo& report_;
  const Graph& graph_;
  GraphFacts facts_;
};

/// The entity that a fact is about: "nodes.smooth" of "nodes.smooth.rate"; else the fact itself.
std::string entity_of(const std::string& key) {
  for (const char* section : {"nodes.", "objects.", "engine"}) {
    if (!key.starts_with(section)) continue;
    const std::size_t begin = std::string_view(section).size();
    const std::size_t dot = key.find('.', section == std::string_view("engine") ? 0 : begin);
    return key.substr(0, dot);
  }
  return key;
}

}  // namespace

GraphFacts facts_of(const PlanInfo& report) {
  return FactCollector(report).all();
}

std::string differences(const GraphFacts& first, const GraphFacts& second) {
  std::string text;
  const auto only = [&](const GraphFacts& here, const GraphFacts& there, char sign) {
    for (const auto& [key, value] : here) {
      const std::string entity = entity_of(key);
      if (there.contains(key) || (entity != key && !there.contains(entity))) continue;
      text += fmt::format("{} {}: {}\n", sign, key, value);
    }
  };
  only(first, second, '-');
  only(second, first, '+');
  for (const auto& [key, value] : first) {
    const auto other = second.find(key);
    if (other != second.end() && other->second != value)
      text += fmt::format("~ {}: {} → {}\n", key, value, other->second);
  }
  return text;
}

}  // namespace eagerx::gen

// messages.hpp and io.hpp: inputs and outputs of the program and of each node.
#include <fmt/format.h>

#include <algorithm>

#include "generator/backend/emit/config.hpp"
#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/types.hpp"

namespace eagerx::gen {
namespace {

View parameter_views(const Config& config) {
  View parameters = list();
  for (const auto& item : config) {
    const CppValue cpp = cpp_value(item);
    if (cpp.type.empty()) continue;
    View parameter = object();
    parameter.set("key", item.parameter->name.value);
    parameter.set("type", cpp.type);
    parameter.set("value", cpp.value);
    parameter.set("comment", text_or_false(item.parameter->unit));
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

/// Objects whose models an entity calculates with.
View model_views(const Config& config) {
  View models = list();
  for (const auto& item : config) {
    const auto* use = std::get_if<std::shared_ptr<const ModelUse>>(&item.value);
    if (use == nullptr) continue;
    View model = object();
    model.set("key", item.parameter->name.value);
    model.set("object", (*use)->object->id.value);
    model.set("engine", (*use)->implementation->engine.value);
    model.set("class", from_global_namespace((*use)->implementation->model.name));
    model.set("has_parameters", !(*use)->config.empty());
    model["parameters"] = parameter_views((*use)->config);
    models.push_back(std::move(model));
  }
  return models;
}

/// The parameters that a struct is compiled for; false if there are none.
View config_view(const Config& config) {
  if (config.empty()) return View(false);
  View view = object();
  view["parameters"] = parameter_views(config);
  view["models"] = model_views(config);
  return view;
}

View node_view(const Plan& plan, std::size_t n, const ProgramNames& names) {
  const GraphNode& node = plan.graph->nodes[n];
  View view = object();
  view.set("node", node.name);
  view.set("entity", node.entity->id.value);
  view.set("rate", node.rate_hz.to_string());
  view.set("rate_type", rate_type(node.rate_hz));
  view.set("type", names.nodes[n].io);
  view.set("config", config_view(node.config));
  View inputs = list(), feedthroughs = list(), targets = list(), delays = list();
  for (std::size_t i = 0; i < node.inputs.size(); ++i) {
    const Input& input = node.inputs[i];
    View port = object();
    port.set("type", window_type(plan, n, i, names.numbers));
    port.set("field", input.name);
    port.set("comment", text_or_false(input.space.describe()));
    port.set("longest", input.max_delay_s
                            ? fmt::format("at most {}", input.max_delay_s->to_string())
                            : "not used: the graph simulates no delays");
    if (input.entity_sets_delay) delays.push_back(port);
    (input.feedthrough ? feedthroughs : inputs).push_back(std::move(port));
  }
  for (const auto& target : node.reset_targets) {
    View port = object();
    port.set("type", names.message(target.space));
    port.set("field", target.name);
    port.set("comment", text_or_false(target.space.describe()));
    targets.push_back(std::move(port));
  }
  view.set("has_inputs", inputs.is_non_empty_list());
  view["inputs"] = std::move(inputs);
  view.set("has_targets", targets.is_non_empty_list());
  view["feedthroughs"] = std::move(feedthroughs);
  view["targets"] = std::move(targets);
  view.set("has_delays", delays.is_non_empty_list());
  view["delays"] = std::move(delays);
  View outputs = list();
  for (const auto& output : node.outputs) {
    View port = object();
    port.set("type", names.message(output.raw));
    port.set("field", output.name);
    outputs.push_back(std::move(port));
  }
  view.set("has_outputs", outputs.is_non_empty_list());
  view["outputs"] = std::move(outputs);
  view.set("has_ports", node.role != NodeRole::engine);
  View states = list();
  for (const auto& state : node.states) {
    View field = object();
    field.set("field", state.name);
    field.set("type", names.message(state.received()));
    states.push_back(std::move(field));
  }
  view.set("has_states", states.is_non_empty_list());
  view["states"] = std::move(states);
  view.set("has_simulator", node.object.has_value());
  view.set("simulator", node.object ? names.objects[*node.object].simulator_type : "");
  return view;
}

View simulators_view(const Plan& plan, const ProgramNames& names) {
  View views = list();
  for (std::size_t i = 0; names.has_engine() && i < plan.graph->objects.size(); ++i) {
    const Object& item = plan.graph->objects[i];
    View view = object();
    view.set("object", item.name);
    view.set("entity", item.entity->id.value);
    view.set("engine", item.implementation->engine.value);
    view.set("type", names.objects[i].simulator_type);
    view.set("simulator", from_global_namespace(plan.graph->engine().entity->simulator.name));
    view.set("model", from_global_namespace(item.implementation->model.name));
    view.set("config", config_view(item.config));
    views.push_back(std::move(view));
  }
  return views;
}

View engine_states_view(const Plan& plan, const ProgramNames& names) {
  View views = list();
  const bool resets = !names.is_vectorized();
  for (std::size_t i = 0; resets && names.has_engine() && i < plan.graph->objects.size(); ++i) {
    const Object& item = plan.graph->objects[i];
    for (std::size_t s = 0; s < item.states.size(); ++s) {
      const State& state = item.states[s];
      View view = object();
      view.set("state", item.name + ".states." + state.name);
      view.set("entity", state.engine_state->id.value);
      view.set("type", names.objects[i].states[s].type);
      view.set("message", names.message(state.received()));
      view.set("simulator", names.objects[i].simulator_type);
      view.set("class", from_global_namespace(state.engine_state->cpp.name));
      view.set("config", config_view(state.config));
      views.push_back(std::move(view));
    }
  }
  return views;
}

View processor_view(const Processor& processor, const std::string& type, const std::string& where,
                    const ProgramNames& names) {
  View view = object();
  view.set("where", where);
  view.set("entity", processor.entity->id.value);
  view.set("type", type);
  view.set("class", from_global_namespace(processor.entity->cpp.name));
  view.set("input", names.message(processor.input));
  view.set("output", names.message(processor.output));
  view.set("config", config_view(processor.config));
  view.set("by_lane", names.is_vectorized() && !runs_vectorized(processor));
  view.set("one", names.in_own_program(type));
  view.set("chain", false);
  return view;
}

/// Several processors, one after the other, as one.
View chain_view(const Processor& last, const std::string& type,
                const std::vector<std::string>& types, const ProgramNames& names) {
  std::string value = "in";
  for (const auto& stage : types) value = fmt::format("{}::convert({})", stage, value);
  View view = object();
  view.set("type", type);
  view.set("input", names.message(last.before.front().input));
  view.set("output", names.message(last.output));
  view.set("value", value);
  return view;
}

View processors_view(const Plan& plan, const ProgramNames& names) {
  View views = list();
  const auto add = [&](const std::optional<Processor>& processor, const std::string& type,
                       const std::string& where) {
    if (!processor) return;
    const auto stages = processor->stages();
    if (stages.size() == 1) {
      views.push_back(processor_view(*processor, type, where, names));
      return;
    }
    const auto& types = names.processor_stages.at(type);
    for (std::size_t i = 0; i < stages.size(); ++i) {
      View view = processor_view(*stages[i], types[i], where, names);
      if (i + 1 == stages.size()) view["chain"] = chain_view(*processor, type, types, names);
      views.push_back(std::move(view));
    }
  };
  const bool resets = !names.is_vectorized();
  for (std::size_t i = 0; resets && names.has_engine() && i < plan.graph->objects.size(); ++i) {
    const Object& item = plan.graph->objects[i];
    for (std::size_t s = 0; s < item.states.size(); ++s)
      add(item.states[s].processor, names.objects[i].states[s].processor,
          item.name + ".states." + item.states[s].name);
  }
  for (std::size_t n = 0; n < plan.graph->nodes.size(); ++n) {
    const GraphNode& node = plan.graph->nodes[n];
    for (std::size_t i = 0; names.receives(n) && i < node.inputs.size(); ++i) {
      const std::string owner = node.role == NodeRole::environment ? "observations" : node.name;
      add(node.inputs[i].processor, names.nodes[n].inputs[i].processor,
          owner + "." + node.inputs[i].name);
    }
    for (std::size_t o = 0; names.runs(n) && o < node.outputs.size(); ++o) {
      add(node.outputs[o].processor, names.nodes[n].outputs[o].processor,
          node.name + "." + node.outputs[o].name);
    }
    for (std::size_t s = 0; resets && names.runs(n) && s < node.states.size(); ++s)
      add(node.states[s].processor, names.nodes[n].states[s].processor,
          node.name + ".states." + node.states[s].name);
    for (std::size_t t = 0; t < node.reset_targets.size(); ++t)
      add(node.reset_targets[t].processor, names.nodes[n].target_processors[t],
          node.name + ".targets." + node.reset_targets[t].name);
  }
  return views;
}

/// `what`: as the graph calls it.
View port_view(const std::string& type, const std::string& field, const std::string& space,
               const std::string& what) {
  View view = object();
  view.set("type", type);
  view.set("field", field);
  view.set("space", space);
  view.set("what", what);
  return view;
}

}  // namespace

View messages_view(const Plan& plan, const ProgramNames& names) {
  const Graph& graph = *plan.graph;
  View view = object();
  view.set("derivatives", names.has_derivatives());
  View actions = list(), observations = list(), states = list();
  view["task"] = outcome_view(plan, names);
  for (const auto& action : graph.environment().outputs)
    actions.push_back(port_view(names.message(action.space), action.name, action.space.describe(),
                                "actions." + action.name));
  const bool observes = names.receives(Graph::kEnvironment);
  std::uint64_t numbers = 0;
  bool may_miss = false;
  for (std::size_t i = 0; observes && i < graph.environment().inputs.size(); ++i) {
    const Input& input = graph.environment().inputs[i];
    const Reception& reception = plan.nodes[Graph::kEnvironment].receptions[i];
    numbers += reception.max_size * input.space.size();
    may_miss = may_miss || input.window == 0;
    observations.push_back(port_view(window_type(plan, Graph::kEnvironment, i, names.numbers),
                                     input.name, input.space.describe(), input.written));
  }
  for (std::size_t i = 0; i < graph.objects.size(); ++i) {
    for (std::size_t s = 0; s < graph.objects[i].states.size(); ++s) {
      const State& state = graph.objects[i].states[s];
      states.push_back(port_view(names.message(state.space), names.objects[i].states[s].field,
                                 state.space.describe(),
                                 graph.objects[i].name + ".states." + state.name));
    }
  }
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    for (std::size_t s = 0; s < graph.nodes[n].states.size(); ++s) {
      const State& state = graph.nodes[n].states[s];
      if (!state.settable) continue;
      states.push_back(port_view(names.message(state.space), names.nodes[n].states[s].field,
                                 state.space.describe(),
                                 graph.nodes[n].name + ".states." + state.name));
    }
  }
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    for (std::size_t i = 0; i < graph.nodes[n].inputs.size(); ++i) {
      const Input& input = graph.nodes[n].inputs[i];
      if (names.nodes[n].inputs[i].delay_state.empty()) continue;
      states.push_back(port_view("double", names.nodes[n].inputs[i].delay_state,
                                 fmt::format("s, at most {}", input.max_delay_s->to_string()),
                                 "delay of " + input.written));
    }
  }
  view.set("has_actions", actions.is_non_empty_list());
  view["actions"] = std::move(actions);
  view.set("numbers", fmt::format("{}", numbers));
  view.set("may_miss", bool_literal(may_miss));
  view.set("has_observations", observations.is_non_empty_list());
  view["observations"] = std::move(observations);
  view.set("has_states", states.is_non_empty_list());
  view["states"] = std::move(states);
  return view;
}

View io_view(const Plan& plan, const ProgramNames& names, const IncludePaths& paths) {
  View view = object();
  view.set("simulators", simulators_view(plan, names));
  view.set("engine_states", engine_states_view(plan, names));
  view.set("processors", processors_view(plan, names));
  view.set("includes", includes_view(plan, names, paths));
  view.set("real", names.real());

  View channels = list();
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    View item = object();
    item.set("constant",
             names.nodes[plan.channels[c].node].outputs[plan.channels[c].output].channel);
    item.set("number", fmt::format("{}", c));
    channels.push_back(std::move(item));
  }
  view["channels"] = std::move(channels);

  std::vector<std::size_t> users(names.nodes.size());  // of the Io of each node
  for (const EmitNode& node : names.nodes) ++users[node.io_owner];
  View nodes = list();
  for (std::size_t n = Graph::kEngine; n < plan.graph->nodes.size(); ++n) {
    if (names.nodes[n].io_owner != n || !names.has_io(n)) continue;
    View node = node_view(plan, n, names);
    node.set("others", users[n] == 1 ? "" : fmt::format(", and {} more alike", users[n] - 1));
    nodes.push_back(std::move(node));
  }
  view["nodes"] = std::move(nodes);
  return view;
}

}  // namespace eagerx::gen

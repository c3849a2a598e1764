#include "generator/graph/resolve/safety.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/graph/resolve/bounds.hpp"
#include "generator/graph/resolve/safe_outputs.hpp"
#include "generator/graph/resolve/states.hpp"

namespace eagerx::gen {

std::vector<double> zero_in(const Space& space) {
  std::vector<double> zero;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const double low = bound_of(space.low, i, lowest_of(space.dtype));
    const double high = bound_of(space.high, i, highest_of(space.dtype));
    zero.push_back(std::min(std::max(0.0, low), high));
  }
  return zero;
}

std::optional<std::vector<double>> safe_value(const std::string& name, const Space& space,
                                              const YamlValue& yaml, Diagnostics& diagnostics) {
  RandomSpec spec;
  spec.kind = RandomSpec::Kind::value;
  spec.span = yaml.span;
  spec.first = yaml;
  const auto random = read_random(name, space, spec, diagnostics);
  return random ? std::optional(random->first) : std::nullopt;
}

void report_unknown_names(const std::vector<Setting>& settings,
                          const std::vector<std::string>& known, std::string_view what,
                          const char* otherwise, Diagnostics& diagnostics) {
  for (const auto& setting : settings) {
    if (contains(known, setting.name)) continue;
    diagnostics.error("E0307", setting.span, fmt::format("there is no {} `{}`", what, setting.name))
        .help = suggestion(setting.name, known, otherwise);
  }
}

namespace {

YamlValue list_of(const std::vector<double>& values, Span span) {
  std::vector<YamlValue> items;
  items.reserve(values.size());
  for (const double value : values) items.push_back(made_number(value, span));
  return made_list(std::move(items), span);
}

/// The safe value of the action that is connected to the actuator as it is, if one is declared.
const Setting* of_connected_action(const GraphSpec& spec, const std::string& object,
                                   const std::string& actuator) {
  for (const auto& connection : spec.connections) {
    const PortName to = parse_port(connection.to.value);
    if (to.owner != object || to.name != actuator) continue;
    if (!to.section.empty() && to.section != "actuators") continue;
    const PortName from = parse_port(connection.from.value);
    if (connection.settings.processor || from.owner != "actions") return nullptr;
    return find_named(spec.safety->actions, from.within_owner());
  }
  return nullptr;
}

/// nullopt if the type of an object is not known.
std::optional<std::vector<std::string>> names_of_actuators(const UnresolvedGraph& draft) {
  std::vector<std::string> names;
  for (const auto& object : draft.objects) {
    if (object.entity == nullptr) return std::nullopt;
    for (const auto& actuator : object.entity->actuators)
      names.push_back(object.name + "." + actuator.name.value);
  }
  return names;
}

void check_time(const std::string& key, const YamlValue& yaml, Diagnostics& diagnostics) {
  constexpr double kLongestS = 3600.0;
  if (exact_of(yaml).value_or(Rational()).to_double() <= kLongestS) return;
  diagnostics.error("E0323", yaml.span, fmt::format("`{}` is out of range", key)).label =
      "must be at most 3600 s";
}

}  // namespace

References safety_references(const GraphSpec& spec) {
  References result;
  for (const auto& [key, value] : safety_defaults()) {
    const Setting* setting = spec.safety ? find_named(spec.safety->settings, key) : nullptr;
    const auto* const number = std::get_if<ComputedNumber>(&value);
    result[{"safety", key}] = setting != nullptr ? setting->value
                              : number != nullptr
                                  ? made_number(*number, spec.name.span)
                                  : made_scalar(std::get<const char*>(value), spec.name.span);
  }
  return result;
}

void add_safe_actuators(UnresolvedGraph& draft, const EntitySpec& object, const Entity& entity,
                        References& references) {
  for (const auto& port : entity.actuators) {
    const std::string& name = port.name.value;
    const std::string written = object.name.value + "." + name;
    Diagnostics quiet;  // problems of the space are reported where it is used
    PartialSpace partial = partial_space(port.space, references, quiet);
    if (object.actuators) {
      const ComponentSpec* set = find_named(*object.actuators, name);
      if (set != nullptr && set->space)
        partial = overlay(partial, partial_space(*set->space, {}, quiet));
    }
    auto space = complete(partial);
    if (!space || quiet.has_errors()) continue;
    if (!check_bounds(*space, {}, quiet)) space->low = space->high = {};
    std::vector<double> safe = zero_in(*space);
    Span span = object.name.span;
    if (draft.spec.safety) {
      const Setting* setting = find_named(draft.spec.safety->actuators, written);
      // The action reports problems of its own value.
      Diagnostics& diagnostics = setting != nullptr ? draft.diagnostics : quiet;
      if (setting == nullptr) setting = of_connected_action(draft.spec, object.name.value, name);
      const auto value = setting != nullptr
                             ? safe_value(written, *space, setting->value, diagnostics)
                             : std::nullopt;
      if (value) {
        safe = *value;
        span = setting->value.span;
      }
    }
    references[{"safe", name}] = list_of(safe, span);
  }
}

void resolve_safety(UnresolvedGraph& draft) {
  if (draft.spec.safety) {
    report_unknown_names(draft.spec.safety->actions,
                         names_of(draft.nodes[Graph::kEnvironment].outputs), "action",
                         "the graph has no actions", draft.diagnostics);
    if (const auto actuators = names_of_actuators(draft)) {
      report_unknown_names(draft.spec.safety->actuators, *actuators, "actuator",
                           "no object has actuators", draft.diagnostics);
    }
    for (const char* key : {"max_lateness", "link_timeout", "heartbeat_timeout"})
      check_time(key, draft.safety.at({"safety", key}), draft.diagnostics);
  }
  if (draft.graph.nodes.empty()) return;  // something was wrong before
  const GraphNode& environment = draft.graph.environment();
  Safety& safety = draft.graph.safety;
  const auto value = [&](const char* key) { return draft.safety.at({"safety", key}); };
  const auto count = [&](const char* key) {
    return static_cast<std::uint32_t>(whole_of(value(key)).value_or(1));
  };
  const auto time_s = [&](const char* key) { return exact_of(value(key)).value_or(Rational()); };
  safety.late = count("late");
  safety.missed = count("missed");
  safety.recover = count("recover");
  safety.clips = value("limits").text == "clip";
  safety.holds = value("not_finite").text == "hold";
  safety.resets_nodes = value("nodes").text == "reset";
  const Rational lateness = time_s("max_lateness");
  safety.max_lateness_s = lateness == Rational() ? Rational(1) / environment.rate_hz : lateness;
  safety.link_timeout_s = time_s("link_timeout");
  safety.heartbeat_timeout_s = time_s("heartbeat_timeout");
  for (const auto& action : environment.outputs) safety.actions.push_back(zero_in(action.space));
  resolve_safe_outputs(draft);
  if (!draft.spec.safety) return;
  safety.declared = true;
  safety.span = draft.spec.safety->span;
  for (std::size_t i = 0; i < environment.outputs.size(); ++i) {
    const Output& action = environment.outputs[i];
    const Setting* setting = find_named(draft.spec.safety->actions, action.name);
    if (setting == nullptr) continue;
    auto safe =
        safe_value("actions." + action.name, action.space, setting->value, draft.diagnostics);
    if (safe) safety.actions[i] = std::move(*safe);
  }
}

}  // namespace eagerx::gen

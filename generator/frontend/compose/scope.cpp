#include "generator/frontend/compose/scope.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

void add_one(const Overrides& said, const char* key, const YamlValue::Entry& entry,
             const std::string& name, YamlValue& settings) {
  for (const std::string& called : {entry.key, entry.key + "[*]", name}) {
    const auto found = said.find(called);
    if (found == said.end() || !settings.is_map()) continue;
    YamlValue& map = map_at(settings, key, entry.key_span);
    if (map.is_sequence()) {  // a list of names
      for (const auto& item : map.items) map.entries.push_back({item.text, item.span, {}});
      map.items.clear();
      map.kind = YamlKind::map;
    }
    for (const auto& each : found->second) set_entry(map, each.key, each.key_span, each.value);
    if (called == name) break;
  }
}

}  // namespace

std::vector<Spanned<std::string>> texts_of(const YamlValue& yaml) {
  std::vector<Spanned<std::string>> result;
  if (yaml.is_scalar()) result.push_back({yaml.text, yaml.span});
  for (const auto& item : yaml.items) result.push_back({item.text, item.span});
  return result;
}

void add_said(const Scope& scope, const YamlValue::Entry& written, const std::string& name,
              YamlValue& settings) {
  add_one(scope.states, "states", written, name, settings);
  add_one(scope.sensors, "sensors", written, name, settings);
  add_one(scope.actuators, "actuators", written, name, settings);
}

void take_states(const YamlValue& settings, Scope& scope, Diagnostics& diagnostics) {
  const YamlValue* states = settings.find("states");
  if (states == nullptr) return;
  for (const auto& entry : states->entries) {
    const std::size_t dot = entry.key.find('.');
    if (dot == std::string::npos) {
      auto& problem =
          diagnostics.error("E0390", entry.key_span,
                            fmt::format("`{}` is not a state of an entity inside", entry.key));
      std::string dotted = entry.key;
      if (const std::size_t slash = dotted.rfind('/'); slash != std::string::npos) {
        dotted[slash] = '.';
        problem.help = write_instead(dotted);
      } else {
        problem.help =
            fmt::format("a composite has the states of what is inside: `NAME.{}`", entry.key);
      }
      continue;
    }
    scope.states[entry.key.substr(0, dot)].push_back(
        {entry.key.substr(dot + 1), entry.key_span, entry.value});
  }
}

void take_settings_of_ports(const YamlValue& settings, const YamlValue& inside, Scope& scope) {
  const auto take = [&](const char* key, const char* bound, Overrides& said) {
    const YamlValue* chosen = settings.find(key);
    const YamlValue* ports = inside.find(key);
    if (chosen == nullptr || ports == nullptr) return;
    for (const auto& entry : chosen->entries) {
      const YamlValue* binding = ports->find(entry.key)->find(bound);
      for (const auto& text : texts_of(*binding)) {
        const std::size_t dot = text.value.find('.');
        said[text.value.substr(0, dot)].push_back(
            {text.value.substr(dot + 1), entry.key_span, entry.value});
      }
    }
  };
  take("sensors", "from", scope.sensors);
  take("actuators", "to", scope.actuators);
}

namespace {

/// `robot.body.mass` and `robot/body.mass` of `robot` are its `body.mass`; empty if it is neither.
std::string spelled_inside(const std::string& state, const std::vector<std::string>& known) {
  const std::string inside = state.substr(state.find_first_of("./") + 1);
  const std::size_t end = inside.find('.');
  if (end == std::string::npos || !contains(known, inside.substr(0, end))) return {};
  return inside;
}

}  // namespace

void report_unknown_inner(const Scope& scope, const YamlValue& graph, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const char* key : {"objects", "nodes"}) {
    const YamlValue* map = graph.find(key);
    if (map == nullptr) continue;
    for (const auto& entry : map->entries) known.push_back(entry.key);
  }
  for (const auto& [name, states] : scope.states) {
    if (contains(known, name.substr(0, name.find('[')))) continue;
    auto& problem = diagnostics.error("E0390", states.front().key_span,
                                      fmt::format("there is no `{}` inside", name));
    const std::string spelled = spelled_inside(name + "." + states.front().key, known);
    const std::string near = nearest(name, known);
    problem.help = !spelled.empty() ? write_instead(spelled)
                   : near.empty()   ? fmt::format("available: {}", join(known, ", "))
                                    : meaning(fmt::format("{}.{}", near, states.front().key));
  }
}

}  // namespace eagerx::gen

// A graph that is being flattened, with the settings from outside.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/frontend/parameters/config.hpp"

namespace eagerx::gen {

/// A composite's settings of its inner entities, by name: entries of `states:`, `sensors:` …
using Overrides = std::map<std::string, std::vector<YamlValue::Entry>>;

/// A graph that is being flattened: the user's, or the contents of one composite.
struct Scope {
  std::string prefix;  // of names in it: "arm/"
  References references;
  std::vector<const Entity*> around;  // the composites that it is in
  Overrides states, sensors, actuators;
};

/// A text, or each of a list.
std::vector<Spanned<std::string>> texts_of(const YamlValue& yaml);

/// Applies the settings of enclosing composites to the entity `written`, named `name`.
void add_said(const Scope& scope, const YamlValue::Entry& written, const std::string& name,
              YamlValue& settings);

/// `states: {position.integral: …}` of a composite: of `integral` of the inner `position`.
/// Problems: E0390.
void take_states(const YamlValue& settings, Scope& scope, Diagnostics& diagnostics);
/// Passes a graph's settings of a composite's sensors and actuators to those inside.
void take_settings_of_ports(const YamlValue& settings, const YamlValue& inside, Scope& scope);
/// Reports states of entities that are not in the graph (E0390).
void report_unknown_inner(const Scope& scope, const YamlValue& graph, Diagnostics& diagnostics);

}  // namespace eagerx::gen

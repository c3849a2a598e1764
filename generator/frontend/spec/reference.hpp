// References `$(…)` in manifests, to settings of the same entity in the graph.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "generator/frontend/read/tree.hpp"

namespace eagerx::gen {

/// `config limit`, `config limit 0`, `size limit`, `sensors theta rate`, `safe u`, `safety late`;
/// `rate` and `index` alone.
struct Reference {
  std::string what;
  std::string name = {};
  std::string part = {};  // of a list: the element; of a sensor or an actuator: "rate"

  friend auto operator<=>(const Reference&, const Reference&) = default;
};

Reference parameter_reference(std::string name);                  // `config NAME`
Reference rate_reference(std::string section, std::string name);  // `sensors NAME rate`

/// "config limit 0", as expressions and messages name it.
std::string to_string(const Reference& reference);
/// "$(config limit 0)", as manifests write it.
std::string in_dollars(const Reference& reference);

/// A reference that was not in a file, at `span`.
YamlValue made_reference(Reference reference, Span span);
/// The reference in a text that contains nothing else.
std::optional<Reference> parse_reference(std::string_view text);
/// The reference in a value; quoted text is not a reference.
std::optional<Reference> reference_in(const YamlValue& yaml);

/// Whether the value computes something from references: `$(2 * config limit)`, `-$(config limit)`,
/// or is one.
bool is_expression(const YamlValue& yaml);

}  // namespace eagerx::gen

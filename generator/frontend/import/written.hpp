// Values and spaces as YAML on one line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/spec/graph_spec.hpp"

namespace eagerx::gen {

/// The nearest name that an entity here may have: "1e3" is "a_1e3".
std::string legal_name(const std::string& text);
/// {a, b}
std::string in_braces(const std::vector<std::string>& items);
std::string text_of(const YamlValue& yaml);
/// ["a", "b"] as "a b", which parameters of ours take for names; nullopt: it is something else.
std::optional<std::string> joined_names(const YamlValue& yaml);
std::string space_text(const SpaceSpec& space);
std::string config_text(const std::vector<Setting>& config);
std::string processor_text(const ProcessorSpec& processor);

}  // namespace eagerx::gen

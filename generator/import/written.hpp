// Values and spaces as YAML on one line.
#pragma once

#include <string>
#include <vector>

#include "generator/spec/graph_spec.hpp"

namespace eagerx::gen {

/// {a, b}
std::string in_braces(const std::vector<std::string>& items);
std::string text_of(const YamlValue& yaml);
std::string space_text(const SpaceSpec& space);

}  // namespace eagerx::gen

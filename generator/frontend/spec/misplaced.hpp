// Keys that are valid elsewhere in the file.
#pragma once

#include <string>
#include <vector>

#include "generator/frontend/spec/format.hpp"

namespace eagerx::gen {

/// A record that knows where some keys belong.
FormatPtr knowing(const FormatPtr& record, std::vector<Elsewhere> elsewhere);

/// Settings of a connection between two such ports. In EAGERx's Python, inputs have them.
Elsewhere of_connections(const std::string& from, const std::string& to);

/// The rate of actions and observations.
Elsewhere rate_of_steps();

/// Where the unknown key of entry `i` belongs, as help for the user: into the value of another key
/// of this record, with the others that do, or where the record's format says, or among the
/// parameters of its type. Empty if unknown. `known`: the record's keys.
std::string help_for_misplaced(const YamlValue& record, std::size_t i, const Format& format,
                               const std::vector<std::string>& known);

}  // namespace eagerx::gen

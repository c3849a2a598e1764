// Names of arguments. Inside command_line/ only.
#pragma once

#include <string>
#include <vector>

#include "generator/command_line/command_line.hpp"

namespace eagerx::gen {

bool is_option(const Argument& argument);
/// "-o,--output": "-o", "--output"
std::vector<std::string> names_of_option(const Argument& argument);

}  // namespace eagerx::gen

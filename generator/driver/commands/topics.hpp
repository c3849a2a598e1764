// Texts of `eagerx-gen help TOPIC`.
#pragma once

#include <vector>

#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {

std::vector<Topic> help_topics();

}  // namespace eagerx::gen

// Completions of a command line in shells. Inside command_line/ only.
#pragma once

#include <string>
#include <vector>

#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {

std::string bash_completion(const CommandLine& line, const std::vector<Command>& commands);
std::string zsh_completion(const CommandLine& line, const std::vector<Command>& commands);
std::string fish_completion(const CommandLine& line, const std::vector<Command>& commands);

}  // namespace eagerx::gen

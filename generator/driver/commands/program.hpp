// Code that `eagerx-gen` and `eagerx-gen-tools` share, except commands.
#pragma once

#include <string_view>
#include <vector>

#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {

/// The program next to `eagerx-gen` that has all commands; it can be left out of a build.
constexpr std::string_view kToolsProgram = "eagerx-gen-tools";

/// The command line of eagerx-gen with these commands.
CommandLine program_command_line(std::vector<Command> commands);

}  // namespace eagerx::gen

// Files generated from a table of commands: manual pages, completions.
#pragma once

#include <string>
#include <vector>

#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {

/// Writes them below `folder`; returns the exit code.
int write_pages(const std::string& folder, const std::vector<CommandLinePage>& pages);

}  // namespace eagerx::gen

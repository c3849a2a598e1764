// Commands whose work a generated program does.
#pragma once

#include <string>
#include <vector>

namespace eagerx::gen {

/// Starts `program` instead of eagerx-gen, so that its output and exit code are the command's. A
/// bare name means a program in this folder. Returns only if it cannot be started: an exit code.
int exec(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace eagerx::gen

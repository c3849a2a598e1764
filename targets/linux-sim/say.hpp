// What a program says before it ends.
#pragma once

#include <string>

namespace eagerx::linux_sim {

/// Prints `text` on the standard error and returns `exit_code`.
int fail(const std::string& text, int exit_code);

}  // namespace eagerx::linux_sim

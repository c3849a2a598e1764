// What a program says before it ends.
#pragma once

#include <string>

namespace eagerx::linux_sim {

/// Prints `text` on the standard error and returns `exit_code`.
int fail(const std::string& text, int exit_code);

/// Prints a note on the standard error; the program goes on.
void say_note(const std::string& text);

}  // namespace eagerx::linux_sim

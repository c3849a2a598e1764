// Messages of a program before it ends.
#pragma once

#include <string>

namespace eagerx::linux_sim {

/// Prints `text` on the standard error and returns `exit_code`.
int fail(const std::string& text, int exit_code);

/// Prints a note on the standard error; the program continues.
void say_note(const std::string& text);

/// Notes that a name was accepted, and how it is spelled.
void say_other_spelling(const std::string& written, const std::string& name);

}  // namespace eagerx::linux_sim

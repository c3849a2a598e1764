// An error that ends a program around a library: caught and printed by main().
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace eagerx::client {

/// Exit codes, as those of eagerx-gen.
enum ExitCode : int {
  kDone = 0,
  kProblems = 1,
  kUsage = 2,
  kInputOutput = 3,
  kInterrupted = 130  // as shells say it
};

struct Problem : std::runtime_error {
  Problem(ExitCode exit_code, const std::string& what, std::string what_to_do = {})
      : std::runtime_error(what), code(exit_code), help(std::move(what_to_do)) {}
  ExitCode code;
  std::string help;                // empty: nothing to say
  std::vector<std::string> about;  // settings by their names, the one to change first
};

enum class For { people, eagerx_gen };

/// Prints the problem and its fix to the standard error; for eagerx-gen, before that, the settings
/// concerned. Returns the exit code.
int tell(const std::exception& error, For whom = For::people);

}  // namespace eagerx::client

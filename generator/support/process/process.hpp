// Other programs: compilers, CMake, and tools that read their output.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eagerx::gen {

struct ProcessResult {
  int exit_code = 0;   // -1: a signal ended it
  std::string output;  // standard output and error, as they came
};

/// Options for running a program, other than its arguments.
struct ProcessOptions {
  std::vector<std::pair<std::string, std::string>> environment = {};  // added to that of eagerx-gen
  /// Called several times a second with the output so far.
  std::function<void(const std::string& output)> waiting = {};
  int input = -1;  // the descriptor of its standard input; -1: none
  /// Called with each line of the standard output, which then is not kept. Standard error is thrown
  /// away: for programs whose output may be long, and is read by a program.
  std::function<void(std::string_view line)> line = {};
};

/// Runs a program, which is looked for in PATH, in the C locale, until it ends; nothing if it could
/// not be started. SIGINT, SIGTERM and SIGHUP end it, all that it started, and then eagerx-gen.
std::optional<ProcessResult> run_process(const std::vector<std::string>& command,
                                         const ProcessOptions& options = {});

/// The file of the command with this name; empty if there is none.
std::string find_program(const std::string& name);

}  // namespace eagerx::gen

// Programs that work on the environments of a graph: eagerx-train, eagerx-campaign.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "generator/driver/commands/arguments.hpp"
#include "generator/support/process/process.hpp"
#include "targets/environments/options/row.hpp"

namespace eagerx::gen {

/// Programs next to eagerx-gen that work on a library of environments.
struct Helper {
  const char* program;
  const char* checker;  // looks at the options with --check, before anything is built
  /// Reports the checker's problem at its place, if known, and returns an exit code; otherwise
  /// kDone.
  std::function<int(const ProcessResult& checked)> explain = {};
  /// Whether the checker also takes `--describes` with description_of() the graph.
  bool looks_at_graph = false;
  /// Whether processes on other machines work with the library, too.
  bool is_shared = false;
};

/// A graph whose library of environments is made, in the folder `output`, for such a program.
struct EnvironmentsOptions : GenerateOptions {
  std::vector<std::string> of_program;  // words for it
};

/// The rows of the program that are for users, as options that are handed on to it.
Arguments handed_on(std::span<const eagerx::options::Row> rows, EnvironmentsOptions& options);
/// The options of making a library of environments.
Arguments on_environments(GenerateOptions& options);

/// Makes the graph's library of environments, and becomes `program` with it and with `words`. They
/// are checked first, before minutes of compiling.
int exec_with_environments(const Helper& helper, const GenerateOptions& options,
                           std::vector<std::string> words);

}  // namespace eagerx::gen

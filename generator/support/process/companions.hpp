// Programs that run alongside this one: a hub's parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace eagerx::gen {

/// A program that lives as long as this process does.
struct Companion {
  std::vector<std::string> command;
  std::string log;    // a file that gets its standard output and error
  std::string ready;  // a file that is there once the program can be used
};

/// Why companions cannot be used.
struct CompanionProblem {
  std::size_t which = 0;
  bool has_ended = false;  // else it takes too long
};

/// Starts programs in a process group of their own and returns when all are ready. They end when
/// this process does, however it ends, also if it has become another program by then; `folder` is
/// removed after them. Their problem, if there is one; then they have ended.
std::optional<CompanionProblem> start_companions(const std::vector<Companion>& companions,
                                                 const std::string& folder);

}  // namespace eagerx::gen

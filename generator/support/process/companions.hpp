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

/// Starts programs in their own process group, and returns when all are ready. They end when this
/// process ends in any way, even if it executes another program in the meantime; `folder` is
/// removed after them. Returns their problem, if any; they have then ended.
std::optional<CompanionProblem> start_companions(const std::vector<Companion>& companions,
                                                 const std::string& folder);

}  // namespace eagerx::gen

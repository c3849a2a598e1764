// A child process that runs while eagerx-gen serves requests, in a thread of its own.
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

struct BackgroundOptions {
  std::string folder;  // that it is started in
  /// Called with each line of its output as it arrives, without its newline.
  std::function<void(std::string_view line, bool is_error)> line;
  /// Called with its group of processes when it has started, and with 0 before that number can be
  /// another one's.
  std::function<void(pid_t group)> group;
};

/// Runs a program, by its path, until it ends; the calling thread waits. Its standard input is
/// empty, and it has its own process group. If that thread ends first, the program gets SIGTERM.
/// Returns its exit code, 128 + N if signal N ended it, or nullopt if it could not be started; see
/// errno.
std::optional<int> run_in_background(const std::vector<std::string>& command,
                                     const BackgroundOptions& options);

}  // namespace eagerx::gen

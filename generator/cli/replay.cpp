// eagerx-gen replay: a program against a log, or two logs; eagerx-gen identify: what a log says of
// parameters and delays. Both are the program's own work.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "generator/cli/commands.hpp"
#include "generator/replay/compare.hpp"

namespace eagerx::gen {
namespace {

/// In place of eagerx-gen, so that the program's output and exit code are the command's. Returns
/// only if it cannot be started.
int become(const std::vector<std::string>& command) {
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  // execvp does not change them, but says so only since it is too late to say it.
  for (const auto& word : command)
    words.push_back(
        const_cast<char*>(word.c_str()));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  words.push_back(nullptr);
  execvp(words[0], words.data());
  fmt::print(stderr, "error: cannot start `{}`: {}\n", command[0], std::strerror(errno));
  return kInputOutput;
}

/// A program in this folder is meant by its bare name.
std::string path_of(const std::string& program) {
  return program.find('/') == std::string::npos ? "./" + program : program;
}

}  // namespace

int replay_command(const Options& options) {
  if (!options.second_log.empty()) {
    const Comparison comparison = compare_logs(options.log, options.second_log);
    std::FILE* const out = comparison.readable ? stdout : stderr;
    fmt::print(out, "{}", comparison.text);
    if (!comparison.readable) return kInputOutput;
    return comparison.equal ? kDone : kProblems;
  }
  std::vector<std::string> command = {path_of(options.program), "--replay", options.log};
  if (!options.given.empty()) command.insert(command.end(), {"--replay-given", options.given});
  return become(command);
}

int identify_command(const Options& options) {
  std::vector<std::string> command = {path_of(options.program), "--identify", options.log};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) command.insert(command.end(), {name, value});
  };
  add("--identify-out", options.output);
  add("--identify-sensors", options.sensors);
  add("--identify-horizon", options.horizon_s);
  add("--identify-delay", options.longest_delay_s);
  return become(command);
}

}  // namespace eagerx::gen

// eagerx-gen replay: a program against a log, which is the program's own work, or two logs.
#include <fmt/format.h>

#include <cstdio>

#include "generator/cli/become.hpp"
#include "generator/cli/commands.hpp"
#include "generator/replay/compare.hpp"

namespace eagerx::gen {

int replay_command(const Options& options) {
  if (!options.second_log.empty()) {
    const Comparison comparison = compare_logs(options.log, options.second_log);
    if (!comparison.readable) {
      complain("{}", comparison.text);
      return kInputOutput;
    }
    say_text(comparison.text);
    return comparison.equal ? kDone : kProblems;
  }
  std::vector<std::string> arguments = {"--replay", options.log};
  if (!options.given.empty()) arguments.insert(arguments.end(), {"--replay-given", options.given});
  return become(options.program, arguments);
}

}  // namespace eagerx::gen

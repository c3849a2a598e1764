// eagerx-gen replay: compares a program with a log, which the program does itself, or two logs.
#include <fmt/format.h>

#include <utility>

#include "generator/driver/build/exec.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/trace/compare_logs.hpp"

namespace eagerx::gen {
namespace {

struct ReplayOptions {
  std::string program, log;
  std::string second_log;  // of two that are compared
  std::string given;       // empty: what the program takes by default
};

int perform(const ReplayOptions& options) {
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
  return exec(options.program, arguments);
}

Command table(ReplayOptions& options) {
  Argument compare{"--compare", "compare two traces instead", "LOG LOG",
                   [&options](const auto& logs) {
                     options.log = logs[0];
                     options.second_log = logs[1];
                   }};
  compare.values = 2;
  compare.use = FileUse::reads;
  return {
      .name = "replay",
      .about = "repeat the run of a trace, and find the first difference",
      .examples = {{"repeat a run that was recorded with --trace",
                    "eagerx-gen replay build/pendulum run.log"},
                   {"the first difference of two runs",
                    "eagerx-gen replay --compare run.log other.log"}},
      .arguments = {reads(text("program", options.program, "program, built for Linux", "PROGRAM")),
                    reads(text("log", options.log, "trace, which a program writes with --trace",
                               "LOG")),
                    text("--given", options.given,
                         "messages to take from the trace: actions, sensors, none, or names of "
                         "channels, separated by commas (default: actions,sensors)",
                         "LIST"),
                    std::move(compare)},
      .check =
          [&options] {
            const bool wrong =
                options.second_log.empty() ? options.log.empty() : !options.program.empty();
            return wrong ? "either PROGRAM and LOG or --compare LOG LOG is required" : "";
          },
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command replay_command() {
  return with_options<ReplayOptions>(table);
}

}  // namespace eagerx::gen

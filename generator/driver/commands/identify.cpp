// eagerx-gen identify: what a log says of parameters and delays. Only the program can repeat the
// log, so the work is its own: runtime/host/identify, which it links.
#include "generator/driver/build/exec.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"

namespace eagerx::gen {
namespace {

struct IdentifyOptions {
  std::string program, log, output;                 // files
  std::string sensors, horizon_s, longest_delay_s;  // empty: what the program takes by default
};

int perform(const IdentifyOptions& options) {
  std::vector<std::string> arguments = {"--identify", options.log};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {name, value});
  };
  add("--identify-out", options.output);
  add("--identify-sensors", options.sensors);
  add("--identify-horizon", options.horizon_s);
  add("--identify-delay", options.longest_delay_s);
  return exec(options.program, arguments);
}

Command table(IdentifyOptions& options) {
  return {.name = "identify",
          .about = "estimate parameters and delays of a robot from its trace",
          .examples = {{"estimate from a robot's trace, and write ranges for a graph's states",
                        "eagerx-gen identify build/pendulum robot.log --output found.yaml"}},
          .arguments = {required(reads(text("program", options.program,
                                            "simulation program, built for Linux", "PROGRAM"))),
                        required(reads(text("log", options.log,
                                            "trace, which a program writes with --trace", "LOG"))),
                        writes(text("-o,--output,--out", options.output,
                                    "file for the YAML (default: print it)", "FILE")),
                        text("--sensors", options.sensors,
                             "channels to fit, separated by commas (default: all sensors)", "LIST"),
                        text("--horizon", options.horizon_s,
                             "length of the pieces of the trace, each with its own initial state, "
                             "in seconds (default: 0.5)",
                             "S"),
                        text("--longest-delay", options.longest_delay_s,
                             "longest actuator delay to consider, in seconds (default: 0.1)", "S")},
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command identify_command() {
  return with_options<IdentifyOptions>(table);
}

}  // namespace eagerx::gen

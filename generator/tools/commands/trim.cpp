// eagerx-gen trim: an operating point of a graph, a state and inputs at which it rests.
#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "generator/driver/commands/arguments.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/commands/trim_point.hpp"

namespace eagerx::gen {
namespace {

struct TrimOptions : LinearOptions {
  TrimSettings settings;
  bool json = false;
};

int perform(const TrimOptions& given) {
  TrimOptions options = given;
  Run run;
  int code = kDone;
  if (!make_linear_graph(run, options) ||
      !check_trim(options.settings, options, *run.plan, run.diagnostics))
    return finish(run, options);
  const auto image = build_linear_program(run, options, code);
  const auto report =
      image ? trim_point(run, *image, options.settings, options, code) : std::nullopt;
  if (report) say_text(options.json ? dump_json(trim_json(*report)) + "\n" : trim_text(*report));
  return std::max(code, finish(run, options));
}

Command table(TrimOptions& options) {
  return {
      .name = "trim",
      .about =
          "find an operating point: a state and constant actions for which the graph rests, within "
          "their bounds",
      .examples = {{"the operating point that is closest to the start of an episode",
                    "eagerx-gen trim robot.yaml"},
                   {"the voltage that holds a pendulum at 0.1 rad",
                    "eagerx-gen trim robot.yaml --fix 'pendulum.model_state[0]=0.1'"},
                   {"at a speed of 2 m/s: the position moves",
                    "eagerx-gen trim robot.yaml --moving 'robot.model_state[0]' --fix "
                    "robot.speed=2"}},
      .arguments = joined(
          {{graph(options),
            texts("--at", options.at, "start the search at this value of a state or an action",
                  "NAME=VALUE")},
           trim_arguments(options.settings),
           {texts("--from", options.settings.from,
                  "inputs: ports whose readers receive a constant instead of messages (default: "
                  "the actions)",
                  "PORT"),
            whole("--steps", options.steps,
                  "steps before the search, for numbers that it does not choose (default: until "
                  "windows are full and delays have passed)",
                  0, 1'000'000'000),
            whole("--seed", options.seed, "seed of random numbers (default: 1)", 0,
                  std::numeric_limits<std::int64_t>::max()),
            choice("--format", {"text", "json"}, "text or JSON (default: text)",
                   [&options](const std::string& name) { options.json = name == "json"; }),
            folder(text(
                "-o,--output", options.output,
                "folder for the program (default: generated/<graph name>-linearize, followed by "
                "the name of a variant or engine)",
                "DIR"))},
           {variant(options), engine(options)},
           rates(options),
           {library(options), warnings(options)},
           diagnostics(options)}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command trim_command() {
  return experimental(with_options<TrimOptions>(table));
}

}  // namespace eagerx::gen

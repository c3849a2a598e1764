// eagerx-gen design: gains of a controller or an observer for the loop as it runs.
#include <limits>
#include <string>
#include <utility>

#include "generator/tools/commands/design_commands.hpp"
#include "generator/tools/commands/tool_commands.hpp"

namespace eagerx::gen {

Arguments design_arguments(DesignOptions& options, std::string types) {
  return joined(
      {{required(text("--of", options.of, "node to design: " + std::move(types), "NODE"))},
       {text("--open", options.open,
             "print the margins of the loop that is opened at this port (default: the output of "
             "the controller)",
             "PORT"),
        texts("--at", options.at,
              "initial state, its elements separated by commas (default: that of the graph)",
              "STATE=VALUE"),
        whole("--steps", options.steps,
              "steps without an action before the operating point (default: until windows are full "
              "and delays have passed, with steady covariances)",
              0, 1'000'000'000),
        whole("--seed", options.seed, "seed of random numbers (default: 1)", 0,
              std::numeric_limits<std::int64_t>::max()),
        flag("--write", options.write, "write the parameters into the graph's file"),
        choice("--format", {"text", "json"}, "text or JSON (default: text)",
               [&options](const std::string& name) { options.json = name == "json"; }),
        folder(
            text("-o,--output", options.output,
                 "folder for the program (default: generated/<graph name>-linearize, followed by "
                 "the name of a variant or engine)",
                 "DIR"))},
       {variant(options), engine(options)},
       rates(options),
       {library(options), warnings(options)},
       diagnostics(options)});
}

Command design_command() {
  return experimental(
      {.name = "design",
       .about = "compute the gains of a controller or an observer for the sampled loop, and print "
                "its margins before and after",
       .commands = {design_lqr_command(), design_kalman_command(), design_pid_command()}});
}

}  // namespace eagerx::gen

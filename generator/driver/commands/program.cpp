#include "generator/driver/commands/program.hpp"

#include "generator/driver/commands/topics.hpp"

namespace eagerx::gen {

CommandLine program_command_line(std::vector<Command> commands) {
  return {
      .top = {.name = "eagerx-gen",
              .about = "Checks an EAGERx graph and writes a C++ program for it.",
              .commands = std::move(commands)},
      .footer =
          "`eagerx-gen GRAPH.yaml` is short for `eagerx-gen generate GRAPH.yaml`. A graph may "
          "also be a file that EAGERx's Graph.save or BaseEnv.save wrote.\n"
          "Exit codes: 0 done, 1 problems found, 2 wrong usage, 3 cannot read or write, 4 a bug "
          "in eagerx-gen.",
      .version = "eagerx-gen " EAGERX_GEN_VERSION,
      .default_command = "generate",
      .topics = help_topics()};
}

}  // namespace eagerx::gen

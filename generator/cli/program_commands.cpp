// The commands that make programs: what they take.
#include "generator/cli/arguments.hpp"
#include "generator/cli/commands.hpp"

namespace eagerx::gen {
namespace {

Arguments output(Options& options) {
  return {
      folder(text("-o,--output", options.output, "output folder (default: generated/<graph name>)",
                  "DIR")),
      flag("--library", options.library,
           "write a library for a main loop of your own instead of a program"),
      cut_out_nodes(
          options,
          "write a library of these nodes, composites or arrays alone; what crosses to the "
          "others becomes its actions and observations. May be repeated"),
      flag("--standalone", options.standalone,
           "also write everything that is needed to compile the output"),
      texts("--package", options.packages,
            "make the output standalone and a package: arduino, esp-idf, platformio or zephyr; "
            "with --library a controller for hardware, without it an episode of the simulation; "
            "may be repeated",
            "NAME"),
      writes(text("--depfile", options.depfile,
                  "also write the files that the output depends on; the make target is FILE "
                  "without .d",
                  "FILE.d"))};
}

}  // namespace

Command generate_commands(Options& options) {
  return {.name = "generate",
          .about = "write the program of a graph",
          .examples = {{"a program for Linux, in generated/pendulum",
                        "eagerx-gen generate pendulum.yaml"},
                       {"for a board, in a folder of your choice",
                        "eagerx-gen generate pendulum.yaml --target mps2-an386 -o out"},
                       {"a tree that compiles without eagerx-gen",
                        "eagerx-gen generate pendulum.yaml --standalone"},
                       {"a controller to flash with Arduino's tools",
                        "eagerx-gen generate controller.yaml --library --package arduino"},
                       {"the controller of a graph with its plant, for a main loop of your own",
                        "eagerx-gen generate robot.yaml --library --of controller"}},
          .arguments = joined({{graph(options)},
                               output(options),
                               selection(options),
                               rates(options),
                               {agent_policy(options), library(options), warnings(options)},
                               diagnostics(options)}),
          .run = [&options] { return generate_command(options); }};
}

namespace {

Arguments building(Options& options) {
  return gen::joined(
      {{graph(options),
        folder(text("-o,--output", options.output,
                    "output folder (default: generated/<graph name>, for another target "
                    "generated/<graph name>-<target>); it is built in its folder `build`",
                    "DIR"))},
       selection(options),
       rates(options),
       {agent_policy(options), library(options), warnings(options)},
       diagnostics(options)});
}

}  // namespace

Command build_commands(Options& options) {
  return {
      .name = "build",
      .about =
          "write the program of a graph, build it, and check the image of a board against the "
          "graph's budget",
      .examples = {{"a program for Linux, in generated/pendulum/build",
                    "eagerx-gen build pendulum.yaml"},
                   {"an image for a board", "eagerx-gen build pendulum.yaml --target stm32f405"}},
      .arguments = building(options),
      .run = [&options] { return build_command(options); }};
}

Command run_commands(Options& options) {
  return {.name = "run",
          .about = "write the program of a graph, build it and run it, if it is within its budget",
          .examples = {{"on Linux; the options of the program follow the graph",
                        "eagerx-gen run pendulum.yaml --seed 1 --steps 300"},
                       {"on the emulator of a board",
                        "eagerx-gen run pendulum.yaml --target mps2-an386 --steps 300 --hash"},
                       {"all that follows `--` is the program's",
                        "eagerx-gen run pendulum.yaml -- --help"}},
          .arguments = building(options),
          .rest = Argument{"program-options",
                           "options of the program: all that eagerx-gen does not know, and all "
                           "that follows `--`; on a board --steps, --seed, --episodes, --agent, "
                           "--csv, --hash",
                           "PROGRAM OPTIONS",
                           [&options](const auto& words) { options.program_options = words; }},
          .check =
              [&options] {
                return options.targets.size() > 1 ? "one --target can be run at a time" : "";
              },
          .run = [&options] { return run_command(options); }};
}

}  // namespace eagerx::gen

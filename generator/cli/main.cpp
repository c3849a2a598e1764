// eagerx-gen: its commands and their options.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

#include "generator/cli/arguments.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/kinds.hpp"
#include "generator/cli/topics.hpp"
#include "generator/command_line/command_line.hpp"
#include "generator/drawing/format.hpp"

namespace eagerx::gen {
namespace {

CommandLine command_line(Options& options);

Command check(Options& options) {
  return {
      .name = "check",
      .about = "only look for problems",
      .examples = {{"look for problems", "eagerx-gen check pendulum.yaml"},
                   {"also the code of the entities", "eagerx-gen check pendulum.yaml --compile"},
                   {"with entities of your own, messages as JSON",
                    "eagerx-gen check pendulum.yaml --path my_models --diagnostics json"}},
      .arguments = joined(
          {{graph(options)},
           selection(options),
           rates(options),
           {library(options), warnings(options)},
           {cut_out_nodes(options, "check the library of these nodes alone, as generate --of"),
            flag("--compile", options.compile,
                 "also compile the entities as boards do: no heap, no <cmath>, no "
                 "double in a graph of floats")},
           diagnostics(options)}),
      .run = [&options] { return check_command(options); }};
}

Command info(Options& options) {
  return {.name = "info",
          .about = "list entities and targets, or explain one or a graph",
          .examples = {{"list what there is", "eagerx-gen info"},
                       {"ports and parameters of an entity", "eagerx-gen info ButterworthFilter"},
                       {"rates, buffers and ages of a graph", "eagerx-gen info pendulum.yaml"},
                       {"what becomes of its composites, arrays and variants",
                        "eagerx-gen info robot.yaml --variant real --flat"}},
          .arguments = joined(
              {{reads(text("entity", options.entity, "id of an entity or target, or a graph file",
                           "ENTITY|GRAPH.yaml")),
                variant(options),
                text("--engine", options.engine, "run the graph on this engine instead of its own",
                     "NAME")},
               rates(options),
               {library(options),
                flag("--flat", options.flat,
                     "print the graph that composites, arrays and variants become, and where its "
                     "lines are from"),
                flag("--json", options.json_output, "print JSON (for graphs only)")}}),
          .run = [&options] { return info_command(options); }};
}

Command diff(Options& options) {
  return {.name = "diff",
          .about =
              "how two graphs differ, or two variants of one: exit code 0 if they do not, 1 if "
              "they do, 2 if one of them has problems",
          .examples = {{"two files", "eagerx-gen diff robot.yaml other.yaml"},
                       {"two variants", "eagerx-gen diff robot.yaml --variant sim --to real"}},
          .arguments = joined(
              {{graph(options),
                reads(text("second", options.second_graph,
                           "the graph to compare with (default: the same file)", "OTHER.yaml")),
                text("--variant", options.variant, "variant of the first graph", "NAME"),
                text("--to", options.second_variant, "variant of the second graph", "NAME"),
                library(options)},
               diagnostics(options)}),
          .run = [&options] { return diff_command(options); }};
}

Command picture(Options& options) {
  Argument output =
      writes(text("-o,--output", options.output,
                  "file of the picture: .svg, .dot (Graphviz) or .mmd (Mermaid) (default: "
                  "<graph name>.svg)",
                  "FILE"));
  output.check = [](const std::string& path) {
    return drawing_format_of(path) ? std::string() : path + " ends in none of .svg, .dot, .mmd";
  };
  return {
      .name = "graph",
      .about = "draw a graph as a picture",
      .examples = {{"pendulum.svg, for a browser or a README", "eagerx-gen graph pendulum.yaml"},
                   {"with the nodes that run on the engine, for Graphviz",
                    "eagerx-gen graph pendulum.yaml --engine-graph -o pendulum.dot"}},
      .arguments = joined(
          {{graph(options), std::move(output),
            flag("--engine-graph", options.engine_graph,
                 "draw what runs on the engine: the nodes of each object instead of one box")},
           {variant(options), text("--engine", options.engine,
                                   "run the graph on this engine instead of its own", "NAME")},
           rates(options),
           {library(options)},
           diagnostics(options)}),
      .run = [&options] { return graph_command(options); }};
}

Command explain(Options& options) {
  return {
      .name = "explain",
      .about = "explain a code such as E0307 and what to do, or list all codes",
      .examples = {{"one code", "eagerx-gen explain E0307"}, {"all codes", "eagerx-gen explain"}},
      .arguments = {text("code", options.code, "such as E0307 or 307 (default: list all codes)",
                         "CODE")},
      .run = [&options] { return explain_command(options); }};
}

Command import(Options& options) {
  return {.name = "import",
          .about = "rewrite a file of EAGERx (Graph.save, BaseEnv.save) as a graph",
          .examples =
              {{"rewrite it, on an engine of your choice",
                "eagerx-gen import state.yaml -o graph.yaml --engine OdeEngine --engine-rate 60"},
               {"a folder to fill in for each class that has no counterpart in C++",
                "eagerx-gen import state.yaml --missing -o models"}},
          .arguments = joined(
              {{required(reads(
                    text("state", options.graph, "the file that EAGERx saved", "STATE.yaml"))),
                writes(text("-o,--output", options.output,
                            "the graph to write (default: print it); with --missing the folder",
                            "FILE")),
                flag("--missing", options.missing,
                     "list the classes without counterpart; with -o make a folder for each"),
                text("--engine", options.engine, "engine to use if the file has none", "NAME")},
               rates(options),
               {library(options)},
               diagnostics(options)}),
          .run = [&options] { return import_command(options); }};
}

Command schema(Options& options) {
  Argument manifest = flag("--manifest", options.manifest_schema, "of manifests");
  return {
      .name = "schema",
      .about = "print a JSON schema, for editors",
      .examples = {{"of graphs, with the entities of eagerx-gen and your own",
                    "eagerx-gen schema --graph --path my_models >graph.schema.json"},
                   {"of manifests", "eagerx-gen schema --manifest >manifest.schema.json"},
                   {"of graphs, whatever the entities", "eagerx-gen schema >graph.schema.json"}},
      .arguments = {flag("--graph", options.graph_schema,
                         "of graphs of this library: ids, ports and parameters of its entities"),
                    std::move(manifest), library(options)},
      .check =
          [&options] {
            const bool both =
                options.manifest_schema && (options.graph_schema || !options.paths.empty());
            return both ? "--manifest takes no --graph and no --path" : "";
          },
      .run = [&options] { return schema_command(options); }};
}

Command make_new(Options& options) {
  Argument kind = required(choice("kind", kinds_of_new(), "what to make",
                                  [&options](const std::string& name) { options.kind = name; }));
  return {
      .name = "new",
      .about = "make a folder to begin with: a project, or a part of your own",
      .examples = {{"a project with a graph that moves at once", "eagerx-gen new project my_robot"},
                   {"in it, a node of your own with a test", "eagerx-gen new node my_filter"},
                   {"a board of your own, in targets/my-board", "eagerx-gen new board my-board"}},
      .arguments = joined(
          {{std::move(kind), required(text("name", options.entity, "its name", "NAME")),
            folder(text("-o,--output", options.output,
                        "where to make its folder (default: here; of a board: targets)", "DIR"))},
           diagnostics(options)}),
      .run = [&options] { return new_command(options); }};
}

Command size(Options& options) {
  return {
      .name = "size",
      .about = "flash, RAM, stack and instructions of an image",
      .examples = {{"flash and RAM of each node", "eagerx-gen size build/pendulum.elf"},
                   {"check a graph's budget and count instructions in the emulator",
                    "eagerx-gen size build/pendulum.elf --graph pendulum.yaml --run mps2-an386"}},
      .arguments = joined(
          {{required(reads(text("image", options.image, "the image", "IMAGE.elf"))),
            reads(text("--graph", options.graph,
                       "also check the image against this graph's `budget:`", "GRAPH.yaml")),
            folder(text("--build", options.build,
                        "build folder of the image (default: the folder that it lies in)", "DIR")),
            variant(options),
            text("--engine", options.engine,
                 "engine that the image was generated with, if not the graph's", "NAME"),
            library(options),
            text("--run", options.run_on, "also count instructions, in the target's emulator",
                 "TARGET"),
            reads(text("--baseline", options.baseline,
                       "an earlier output of --json; if a budget is exceeded, name the parts that "
                       "grew",
                       "FILE.json")),
            flag("--json", options.json_output, "print JSON")},
           diagnostics(options)}),
      .run = [&options] { return size_command(options); }};
}

Command replay(Options& options) {
  Argument compare{"--compare", "compare two logs instead", "LOG LOG",
                   [&options](const auto& logs) {
                     options.log = logs[0];
                     options.second_log = logs[1];
                   }};
  compare.values = 2;
  compare.use = FileUse::reads;
  return {.name = "replay",
          .about = "repeat the run of a log and find the first difference",
          .examples = {{"repeat a run that was recorded with --trace",
                        "eagerx-gen replay build/pendulum run.log"},
                       {"the first difference of two runs",
                        "eagerx-gen replay --compare run.log other.log"}},
          .arguments = {reads(text("program", options.program, "the program, built for Linux",
                                   "PROGRAM")),
                        reads(text("log", options.log, "what a run wrote with --trace", "LOG")),
                        text("--given", options.given,
                             "messages to take from the log: actions, sensors, none or names of "
                             "channels, separated by commas (default: actions,sensors)",
                             "LIST"),
                        std::move(compare)},
          .check =
              [&options] {
                const bool wrong =
                    options.second_log.empty() ? options.log.empty() : !options.program.empty();
                return wrong ? "either PROGRAM and LOG or --compare LOG LOG is required" : "";
              },
          .run = [&options] { return replay_command(options); }};
}

Command identify(Options& options) {
  return {.name = "identify",
          .about = "find the parameters and delays that a log was made with",
          .examples = {{"from a robot's log, as ranges for a graph's states",
                        "eagerx-gen identify build/pendulum robot.log --out found.yaml"}},
          .arguments =
              {required(reads(text("program", options.program,
                                   "the program of a simulation, built for Linux", "PROGRAM"))),
               required(reads(text("log", options.log, "what a run wrote with --trace", "LOG"))),
               writes(text("-o,--out", options.output, "file for the YAML (default: print it)",
                           "FILE")),
               text("--sensors", options.sensors,
                    "channels to fit, separated by commas (default: all sensors)", "LIST"),
               text("--horizon", options.horizon_s,
                    "seconds that the simulation runs from one guess of the state "
                    "(default: 0.5)",
                    "S"),
               text("--longest-delay", options.longest_delay_s,
                    "longest delay of an actuator to try, in seconds (default: 0.1)", "S")},
          .run = [&options] { return identify_command(options); }};
}

Command pages(Options& options) {
  return {
      .name = "pages",
      .about = "write the manual pages and completions that are installed",
      .arguments = {required(folder(text("folder", options.output, "where", "DIR")))},
      .run =
          [&options] { return pages_command(options, command_line_pages(command_line(options))); },
      .hidden = true};
}

CommandLine command_line(Options& options) {
  return {
      .top = {.name = "eagerx-gen",
              .about = "Checks an EAGERx graph and writes a C++ program for it.",
              .commands = {generate_commands(options),
                           build_commands(options),
                           run_commands(options),
                           train_commands(options),
                           campaign_commands(options),
                           pil_commands(options),
                           check(options),
                           info(options),
                           diff(options),
                           picture(options),
                           report_commands(options),
                           explain(options),
                           import(options),
                           schema(options),
                           make_new(options),
                           size(options),
                           replay(options),
                           identify(options),
                           trace_commands(options),
                           plot_commands(options),
                           monitor_commands(options),
                           policy_commands(options),
                           pages(options)}},
      .footer =
          "`eagerx-gen GRAPH.yaml` is short for `eagerx-gen generate GRAPH.yaml`. A graph may "
          "also be a file that EAGERx's Graph.save or BaseEnv.save wrote.\n"
          "Exit codes: 0 done, 1 problems found, 2 wrong usage, 3 cannot read or write, 4 a bug "
          "in eagerx-gen.",
      .version = "eagerx-gen " EAGERX_GEN_VERSION,
      .default_command = "generate",
      .topics = help_topics()};
}

}  // namespace
}  // namespace eagerx::gen

int main(int argc, char** argv) {
  try {
    eagerx::gen::Options options;
    return eagerx::gen::run_command_line(
        eagerx::gen::command_line(options),
        std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr,
                 "error: this is a bug in eagerx-gen: %s\nhelp: please report it with the graph\n",
                 error.what());
    return eagerx::gen::kInternal;
  }
}

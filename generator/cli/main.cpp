// eagerx-gen: its commands and their options.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

#include "generator/cli/commands.hpp"
#include "generator/cli/kinds.hpp"
#include "generator/cli/topics.hpp"
#include "generator/command_line/command_line.hpp"
#include "generator/picture/picture.hpp"
#include "generator/read/quantity.hpp"

namespace eagerx::gen {
namespace {

using Arguments = std::vector<Argument>;

CommandLine command_line(Options& options);

Arguments joined(std::initializer_list<Arguments> parts) {
  Arguments all;
  for (const Arguments& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Argument graph(Options& options) {
  return required(text("graph", options.graph, "the graph file", "GRAPH.yaml"));
}

std::string check_split(const std::string& text) {
  const std::size_t equals = text.find('=');
  const bool complete = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
  return complete ? std::string() : text + " is not NAME[,NAME...]=BOARD";
}

Arguments selection(Options& options) {
  Argument split =
      texts("--split", options.split,
            "make two programs, one for a board and one for Linux; on the board run the named "
            "nodes, `agent`, or `controller` (the agent and all nodes). Replaces the graph's "
            "`placement`",
            "NAME[,NAME...]=BOARD");
  split.check = check_split;
  return {
      text("--engine", options.engine, "run the graph on this engine instead of its own", "NAME"),
      choice("--real", {"float", "double"}, "calculate in this type instead of the graph's `real`",
             [&options](const std::string& real) { options.real = real; }),
      texts("--target", options.targets,
            "target to make a program for, may be repeated (default: linux-sim)", "NAME"),
      std::move(split)};
}

Argument rate(std::string name, std::string about, std::optional<Rational>& rate_hz) {
  Argument argument{std::move(name), std::move(about), "HZ", [&rate_hz](const auto& values) {
                      rate_hz = parse_quantity(values.front(), Quantity::rate);
                    }};
  argument.check = [](const std::string& text) {
    const auto value = parse_quantity(text, Quantity::rate);
    return value && *value > Rational() ? std::string()
                                        : text + " is not a rate such as 30, 30Hz or 30000/1001";
  };
  return argument;
}

Argument agent_policy(Options& options) {
  return text("--policy", options.agent_policy,
              "weight file of a policy that decides instead of the graph's `agent`", "FILE");
}

Arguments rates(Options& options) {
  return {
      rate("--rate", "use this rate of the environment instead of the graph's", options.rate_hz),
      rate("--engine-rate", "use this rate of the engine instead of the graph's",
           options.engine_rate_hz)};
}

Argument library(Options& options) {
  return texts("--path", options.paths,
               "folder with entities or targets of your own, may be repeated", "DIR");
}

Arguments output(Options& options) {
  return {
      text("-o,--output", options.output, "output folder (default: generated/<graph name>)", "DIR"),
      flag("--library", options.library,
           "write a library for a main loop of your own instead of a program"),
      flag("--standalone", options.standalone,
           "also write everything that is needed to compile the output"),
      texts("--package", options.packages,
            "make the output standalone and a package: arduino, esp-idf, platformio or zephyr; "
            "may be repeated",
            "NAME"),
      text("--depfile", options.depfile,
           "also write the files that the output depends on; the make target is FILE without .d",
           "FILE.d")};
}

Arguments diagnostics(Options& options) {
  return {choice("--diagnostics", {"text", "json"}, "form of messages (default: text)",
                 [&options](const std::string& form) { options.json = form == "json"; }),
          flag("-q,--quiet", options.quiet, "print problems only")};
}

Argument warnings(Options& options) {
  return flag("--warnings-as-errors", options.warnings_as_errors,
              "a warning is a problem: exit code 1, and nothing is written");
}

Arguments policy(Options& options) {
  return joined(
      {{required(text("file", options.policy, "the weight file", "FILE")),
        text("--normalize", options.normalize,
             "statistics of the observations: VecNormalize.save, npz or JSON", "FILE"),
        text("--activation", options.activation,
             "activation of the hidden layers, if the file does not say it", "NAME"),
        text("--output-activation", options.output_activation,
             "what follows the last layer (such as none or tanh), if the file does not say it",
             "NAME"),
        text("--actor", options.actor,
             "of a file with several actors: how the names of its tensors begin", "NAME"),
        text("--output", options.output_name, "which output of an ONNX file is the action",
             "NAME")},
       diagnostics(options)});
}

Command generate(Options& options) {
  return {.name = "generate",
          .about = "write the program of a graph",
          .examples = {{"a program for Linux, in generated/pendulum",
                        "eagerx-gen generate pendulum.yaml"},
                       {"for a board, in a folder of your choice",
                        "eagerx-gen generate pendulum.yaml --target mps2-an386 -o out"},
                       {"a tree that compiles without eagerx-gen, also as an Arduino library",
                        "eagerx-gen generate pendulum.yaml --standalone --package arduino"}},
          .arguments = joined({{graph(options)},
                               output(options),
                               selection(options),
                               rates(options),
                               {agent_policy(options), library(options), warnings(options)},
                               diagnostics(options)}),
          .run = [&options] { return generate_command(options); }};
}

Arguments building(Options& options) {
  return joined(
      {{graph(options), text("-o,--output", options.output,
                             "output folder (default: generated/<graph name>, for another target "
                             "generated/<graph name>-<target>); it is built in its folder `build`",
                             "DIR")},
       selection(options),
       rates(options),
       {agent_policy(options), library(options), warnings(options)},
       diagnostics(options)});
}

Command build(Options& options) {
  return {
      .name = "build",
      .about = "write the program of a graph and build it",
      .examples = {{"a program for Linux, in generated/pendulum/build",
                    "eagerx-gen build pendulum.yaml"},
                   {"an image for a board", "eagerx-gen build pendulum.yaml --target stm32f405"}},
      .arguments = building(options),
      .run = [&options] { return build_command(options); }};
}

Command run(Options& options) {
  return {.name = "run",
          .about = "write the program of a graph, build it and run it",
          .examples = {{"on Linux; the options of the program follow the graph",
                        "eagerx-gen run pendulum.yaml --seed 1 --steps 300"},
                       {"on the emulator of a board",
                        "eagerx-gen run pendulum.yaml --target mps2-an386 --steps 300 --hash"},
                       {"all that follows `--` is the program's",
                        "eagerx-gen run pendulum.yaml -- --help"}},
          .arguments = building(options),
          .rest = Argument{"program-options",
                           "options of the program: all that eagerx-gen does not know, and all "
                           "that follows `--`",
                           "PROGRAM OPTIONS",
                           [&options](const auto& words) { options.program_options = words; }},
          .check =
              [&options] {
                return options.targets.size() > 1 ? "one --target can be run at a time" : "";
              },
          .run = [&options] { return run_command(options); }};
}

/// An option that the program which is started understands.
Argument handed_on(const std::string& name, std::string about, std::string type, Options& options) {
  return {name, std::move(about), std::move(type), [&options, name](const auto& values) {
            for (const std::string& value : values) {
              options.program_options.push_back(name.substr(0, name.find(',')));
              options.program_options.push_back(value);
            }
          }};
}

/// What making a library of environments takes.
Arguments on_environments(Options& options) {
  return joined({{text("--build", options.output,
                       "folder for the library of environments (default: generated/<graph "
                       "name>-environments)",
                       "DIR"),
                  text("--engine", options.engine,
                       "run the graph on this engine instead of its own", "NAME")},
                 rates(options),
                 {library(options), warnings(options)},
                 diagnostics(options)});
}

Command train(Options& options) {
  const auto option = [&options](const char* name, const char* about, const char* type) {
    return handed_on(name, about, type, options);
  };
  return {
      .name = "train",
      .about = "train a policy on the graph, whose `task:` says what is good",
      .examples =
          {{"until it succeeds: writes policy.safetensors", "eagerx-gen train pendulum.yaml"},
           {"with another seed, and a picture of the learning curve",
            "eagerx-gen train pendulum.yaml --seed 2 --curve curve.svg -o swing_up.safetensors"},
           {"a long one that can be interrupted",
            "eagerx-gen train robot.yaml --steps 50000000 --checkpoint robot.checkpoint"},
           {"and goes on",
            "eagerx-gen train robot.yaml --steps 50000000 --resume robot.checkpoint"}},
      .arguments = joined(
          {{graph(options),
            option("-o,--output", "the policy (default: policy.safetensors)", "FILE"),
            option("--algorithm", "ppo (default); there is no other", "NAME"),
            option("--steps", "steps of all environments, at most (default: 5000000)", "N"),
            option("--seed",
                   "where random numbers start: another seed gives another policy (default: 1)",
                   "N"),
            option("--threads",
                   "how many threads; the policy is the same for any number (default: one for each "
                   "core)",
                   "N"),
            option("--hidden", "widths of the hidden layers (default: 64,64)", "N,N"),
            option("--discount", "weight of a reward one step later (default: 0.99)", "X"),
            option("--checkpoint", "write here, every few seconds, what --resume needs", "FILE"),
            option("--resume", "go on from a checkpoint: the policy is that of one long run",
                   "FILE"),
            option("--csv", "write the learning curve as a table", "FILE"),
            option("--curve", "write the learning curve as a picture (SVG)", "FILE")},
           on_environments(options)}),
      .run = [&options] { return train_command(options); }};
}

Command campaign(Options& options) {
  const auto option = [&options](const char* name, const char* about, const char* type) {
    return handed_on(name, about, type, options);
  };
  Argument vary = option("--vary",
                         "draw a state or a delay of each run from this range, may be repeated; an "
                         "element is NAME[0]",
                         "NAME=LOW:HIGH");
  vary.repeated = true;
  return {
      .name = "campaign",
      .about = "run many episodes with the agent in the loop and count successes",
      .examples =
          {{"10,000 episodes: how often it succeeds, and what repeats the worst ones",
            "eagerx-gen campaign pendulum.yaml --runs 10000"},
           {"with masses drawn from a range; a row for each run",
            "eagerx-gen campaign pendulum.yaml --vary pendulum.mass=0.1:0.2 --csv runs.csv"},
           {"a long one that can be interrupted",
            "eagerx-gen campaign robot.yaml --runs 1000000 --checkpoint robot.campaign"},
           {"and goes on",
            "eagerx-gen campaign robot.yaml --runs 1000000 --resume robot.campaign"}},
      .arguments = joined(
          {{graph(options), option("--runs", "episodes (default: 1000)", "N"), std::move(vary),
            agent_policy(options),
            option("--steps",
                   "end an episode after so many steps (default: what the task says, or 300)", "N"),
            option("--seed",
                   "where random numbers start: another seed is another campaign (default: 1)",
                   "N"),
            option("--threads",
                   "how many threads; the report is the same for any number (default: one for each "
                   "core)",
                   "N"),
            option("--worst", "name so many of the worst runs (default: 5)", "N"),
            option("--csv", "write a table with a row for each run", "FILE"),
            flag("--json", options.json_output, "print the report as JSON"),
            option("--checkpoint", "add finished runs to this file, for --resume", "FILE"),
            option("--resume", "go on from a checkpoint: the report is that of one long run",
                   "FILE")},
           on_environments(options)}),
      .run = [&options] { return campaign_command(options); }};
}

Command check(Options& options) {
  return {
      .name = "check",
      .about = "only look for problems",
      .examples = {{"look for problems", "eagerx-gen check pendulum.yaml"},
                   {"also the code of the entities", "eagerx-gen check pendulum.yaml --compile"},
                   {"with entities of your own, messages as JSON",
                    "eagerx-gen check pendulum.yaml --path my_models --diagnostics json"}},
      .arguments = joined({{graph(options)},
                           selection(options),
                           rates(options),
                           {library(options), warnings(options)},
                           {flag("--compile", options.compile,
                                 "also compile the entities as boards do: no heap, no <cmath>, no "
                                 "double in a graph of floats")},
                           diagnostics(options)}),
      .run = [&options] { return check_command(options); }};
}

Command info(Options& options) {
  return {
      .name = "info",
      .about = "list entities and targets, or explain one or a graph",
      .examples = {{"list what there is", "eagerx-gen info"},
                   {"ports and parameters of an entity", "eagerx-gen info ButterworthFilter"},
                   {"rates, buffers and ages of a graph", "eagerx-gen info pendulum.yaml"}},
      .arguments = joined({{text("entity", options.entity,
                                 "id of an entity or target, or a graph file", "ENTITY|GRAPH.yaml"),
                            text("--engine", options.engine,
                                 "run the graph on this engine instead of its own", "NAME")},
                           rates(options),
                           {library(options),
                            flag("--json", options.json_output, "print JSON (for graphs only)")}}),
      .run = [&options] { return info_command(options); }};
}

Command picture(Options& options) {
  Argument output = text("-o,--output", options.output,
                         "file of the picture: .svg, .dot (Graphviz) or .mmd (Mermaid) (default: "
                         "<graph name>.svg)",
                         "FILE");
  output.check = [](const std::string& path) {
    return picture_format_of(path) ? std::string() : path + " ends in none of .svg, .dot, .mmd";
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
           {text("--engine", options.engine, "run the graph on this engine instead of its own",
                 "NAME")},
           rates(options),
           {library(options)},
           diagnostics(options)}),
      .run = [&options] { return graph_command(options); }};
}

Command report(Options& options) {
  Argument points{"--points",
                  "most points of a plot (default: as many as keep the file below 5 MB, at most "
                  "2000); of more messages, the least and the greatest of each part are kept",
                  "N", [&options](const auto& values) {
                    options.points = std::strtoul(values.front().c_str(), nullptr, 10);
                  }};
  points.check = [](const std::string& text) {
    const bool digits = !text.empty() && text.size() < 8 &&
                        text.find_first_not_of("0123456789") == std::string::npos;
    return digits && std::strtoul(text.c_str(), nullptr, 10) >= 2
               ? std::string()
               : text + " is not a number from 2 to 9999999";
  };
  return {
      .name = "report",
      .about = "show everything about a graph on one page for a browser",
      .examples = {{"drawing, timetable, memory and ages, in pendulum.html",
                    "eagerx-gen report pendulum.yaml"},
                   {"with a run as plots, and the flash and RAM of an image",
                    "eagerx-gen report pendulum.yaml --trace run.log --image build/pendulum.elf -o "
                    "run.html"}},
      .arguments = joined(
          {{graph(options),
            text("-o,--output", options.output, "the page (default: <graph name>.html)", "FILE"),
            texts("--trace", options.logs, "what a run wrote with --trace, may be repeated", "LOG"),
            texts("--image", options.images, "an image of a board, may be repeated", "IMAGE.elf"),
            text("--build", options.build,
                 "build folder of the image (default: the folder that it lies in)", "DIR"),
            std::move(points)},
           {text("--engine", options.engine, "run the graph on this engine instead of its own",
                 "NAME")},
           rates(options),
           {library(options)},
           diagnostics(options)}),
      .run = [&options] { return report_command(options); }};
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
              {{required(text("state", options.graph, "the file that EAGERx saved", "STATE.yaml")),
                text("-o,--output", options.output,
                     "the graph to write (default: print it); with --missing the folder", "FILE"),
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
      .arguments =
          joined({{std::move(kind), required(text("name", options.entity, "its name", "NAME")),
                   text("-o,--output", options.output,
                        "where to make its folder (default: here; of a board: targets)", "DIR")},
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
          {{required(text("image", options.image, "the image", "IMAGE.elf")),
            text("--graph", options.graph, "also check the image against this graph's `budget:`",
                 "GRAPH.yaml"),
            text("--build", options.build,
                 "build folder of the image (default: the folder that it lies in)", "DIR"),
            text("--engine", options.engine,
                 "engine that the image was generated with, if not the graph's", "NAME"),
            library(options),
            text("--run", options.run_on, "also count instructions, in the target's emulator",
                 "TARGET"),
            text("--baseline", options.baseline,
                 "an earlier output of --json; if a budget is exceeded, name the parts that grew",
                 "FILE.json"),
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
  return {.name = "replay",
          .about = "repeat the run of a log and find the first difference",
          .examples = {{"repeat a run that was recorded with --trace",
                        "eagerx-gen replay build/pendulum run.log"},
                       {"the first difference of two runs",
                        "eagerx-gen replay --compare run.log other.log"}},
          .arguments = {text("program", options.program, "the program, built for Linux", "PROGRAM"),
                        text("log", options.log, "what a run wrote with --trace", "LOG"),
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
  return {
      .name = "identify",
      .about = "find the parameters and delays that a log was made with",
      .examples = {{"from a robot's log, as ranges for a graph's states",
                    "eagerx-gen identify build/pendulum robot.log --out found.yaml"}},
      .arguments = {required(text("program", options.program,
                                  "the program of a simulation, built for Linux", "PROGRAM")),
                    required(text("log", options.log, "what a run wrote with --trace", "LOG")),
                    text("-o,--out", options.output, "file for the YAML (default: print it)",
                         "FILE"),
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

Command policies(Options& options) {
  const auto run = [&options] { return policy_command(options); };
  return {
      .name = "policy",
      .about = "look into a trained policy",
      .examples = {{"layers, size and what it expects", "eagerx-gen policy info swing_up.onnx"},
                   {"its error on known answers",
                    "eagerx-gen policy test swing_up.onnx answers.csv"}},
      .commands = {
          {.name = "info",
           .about = "layers, size and what it expects of a graph",
           .examples = {{"an ONNX file", "eagerx-gen policy info swing_up.onnx"},
                        {"a model of Stable-Baselines3 with its statistics",
                         "eagerx-gen policy info sac.zip --normalize vec_normalize.pkl"}},
           .arguments = policy(options),
           .run = run},
          {.name = "test",
           .about = "compare its answers with known answers",
           .examples = {{"rows of a CSV file", "eagerx-gen policy test swing_up.onnx answers.csv"}},
           .arguments = joined(
               {policy(options),
                {required(text("golden", options.golden, "rows of observations and known answers",
                               "GOLDEN.csv|npz"))}}),
           .run = run}}};
}

Command pages(Options& options) {
  return {
      .name = "pages",
      .about = "write the manual pages and completions that are installed",
      .arguments = {required(text("folder", options.output, "where", "DIR"))},
      .run =
          [&options] { return pages_command(options, command_line_pages(command_line(options))); },
      .hidden = true};
}

CommandLine command_line(Options& options) {
  return {
      .top = {.name = "eagerx-gen",
              .about = "Checks an EAGERx graph and writes a C++ program for it.",
              .commands = {generate(options), build(options),          run(options),
                           train(options),    campaign(options),       check(options),
                           info(options),     picture(options),        report(options),
                           explain(options),  import(options),         schema(options),
                           make_new(options), size(options),           replay(options),
                           identify(options), trace_commands(options), plot_commands(options),
                           policies(options), pages(options)}},
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

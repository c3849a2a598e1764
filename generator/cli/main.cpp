// eagerx-gen: command line.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>

#include "generator/cli/commands.hpp"
#include "generator/cli/usage.hpp"

namespace {

using eagerx::gen::Options;

/// Without a description: the help shows the choices as the type already.
CLI::Validator one_of(const std::vector<std::string>& choices) {
  return CLI::IsMember(choices).description("");
}

void add_graph(CLI::App& app, Options& options) {
  app.add_option("graph", options.graph, "the graph file")->required()->type_name("GRAPH.yaml");
}

void add_selection(CLI::App& app, Options& options) {
  app.add_option("--engine", options.engine, "run on this engine instead of the graph's")
      ->type_name("NAME");
  app.add_option("--real", options.real, "calculate in float or double instead of the graph's")
      ->check(one_of({"float", "double"}))
      ->type_name("float|double");
  app.add_option("--target", options.targets,
                 "target to make a program for, may be repeated (default: linux-sim)")
      ->allow_extra_args(false)  // what follows is the graph
      ->type_name("NAME");
  app.add_option("--split", options.split,
                 "make two programs: nodes, `agent` or `controller` (both) on a board, the rest on "
                 "Linux, in place of the graph's `placement`")
      ->check(CLI::Validator(
          [](const std::string& text) {
            const std::size_t equals = text.find('=');
            const bool complete =
                equals != std::string::npos && equals > 0 && equals + 1 < text.size();
            return complete ? std::string() : text + " is not NAME[,NAME...]=BOARD";
          },
          ""))
      ->allow_extra_args(false)
      ->type_name("NAME[,NAME...]=BOARD");
}

void add_rate(CLI::App& app, const char* name, const char* about,
              std::optional<eagerx::gen::Rational>& rate) {
  app.add_option_function<std::string>(
         name, [&rate](const std::string& text) { rate = eagerx::gen::Rational::parse(text); },
         about)
      ->check(CLI::Validator(
          [](const std::string& text) {
            const auto value = eagerx::gen::Rational::parse(text);
            return value && *value > eagerx::gen::Rational() ? std::string()
                                                             : text + " is no rate in Hz";
          },
          ""))
      ->type_name("HZ");
}

void add_rates(CLI::App& app, Options& options) {
  add_rate(app, "--rate", "rate of the environment instead of the graph's", options.rate_hz);
  add_rate(app, "--engine-rate", "rate of the engine instead of the graph's",
           options.engine_rate_hz);
}

void add_library(CLI::App& app, Options& options) {
  app.add_option("--path", options.paths,
                 "folder with entities or targets of your own, may be repeated")
      ->allow_extra_args(false)
      ->type_name("DIR");
}

void add_output(CLI::App& app, Options& options) {
  app.add_option("-o,--output", options.output, "output folder (default: generated/<graph name>)")
      ->type_name("DIR");
  app.add_flag("--standalone", options.standalone,
               "put everything into the output that is needed to compile it");
  app.add_option("--package", options.packages,
                 "make the output a package too, and standalone: arduino, esp-idf, platformio, "
                 "zephyr; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME");
  app.add_option("--depfile", options.depfile,
                 "also write what the output depends on; names FILE without its .d as the target")
      ->type_name("FILE.d");
}

void add_diagnostics(CLI::App& app, Options& options) {
  app.add_option_function<std::string>(
         "--diagnostics", [&options](const std::string& form) { options.json = form == "json"; },
         "form of messages (default: text)")
      ->check(one_of({"text", "json"}))
      ->type_name("text|json");
  app.add_flag("-q,--quiet", options.quiet, "print problems only");
}

void add_policy(CLI::App& app, Options& options) {
  app.add_option("file", options.policy, "the weight file")->required()->type_name("FILE");
  app.add_option("--normalize", options.normalize,
                 "statistics of the observations: VecNormalize.save, npz or JSON")
      ->type_name("FILE");
  app.add_option("--activation", options.activation,
                 "of hidden layers, if the file does not say it")
      ->type_name("NAME");
  add_diagnostics(app, options);
}

void add_size(CLI::App& app, Options& options) {
  app.add_option("image", options.image, "the image")->required()->type_name("IMAGE.elf");
  app.add_option("--graph", options.graph, "also check it against this graph's `budget:`")
      ->type_name("GRAPH.yaml");
  app.add_option("--build", options.build, "its build folder (default: where it lies)")
      ->type_name("DIR");
  app.add_option("--engine", options.engine, "the graph's engine in the image")->type_name("NAME");
  add_library(app, options);
  app.add_option("--run", options.run_on, "also count instructions, in the target's emulator")
      ->type_name("TARGET");
  app.add_option("--baseline", options.baseline,
                 "an earlier output of --json: name what grew when a budget is exceeded")
      ->type_name("FILE.json");
  app.add_flag("--json", options.json_output, "print JSON");
  add_diagnostics(app, options);
}

void add_replay(CLI::App& app, Options& options) {
  app.add_option("program", options.program, "the program, built for Linux")->type_name("PROGRAM");
  app.add_option("log", options.log, "what a run wrote with --trace")->type_name("LOG");
  app.add_option("--given", options.given,
                 "what is taken from the log: channels, actions, sensors, none, between commas "
                 "(default: actions,sensors)")
      ->type_name("LIST");
  app.add_option_function<std::vector<std::string>>(
         "--compare",
         [&options](const std::vector<std::string>& logs) {
           options.log = logs[0];
           options.second_log = logs[1];
         },
         "compare two logs instead")
      ->expected(2)
      ->type_name("LOG LOG");
  app.callback([&options] {
    if (options.second_log.empty() ? options.log.empty() : !options.program.empty())
      throw CLI::RequiredError("either PROGRAM and LOG or --compare LOG LOG");
  });
}

void add_identify(CLI::App& app, Options& options) {
  app.add_option("program", options.program, "the program of a simulation, built for Linux")
      ->required()
      ->type_name("PROGRAM");
  app.add_option("log", options.log, "what a run wrote with --trace")->required()->type_name("LOG");
  app.add_option("-o,--out", options.output, "file for the YAML (default: print it)")
      ->type_name("FILE");
  app.add_option("--sensors", options.sensors,
                 "channels that count, between commas (default: all sensors)")
      ->type_name("LIST");
  app.add_option("--horizon", options.horizon_s,
                 "seconds that the simulation runs from one guess of the state (default: 0.5)")
      ->type_name("S");
  app.add_option("--longest-delay", options.longest_delay_s,
                 "longest delay of an actuator to try, in seconds (default: 0.1)")
      ->type_name("S");
}

constexpr const char* kFooter =
    "`eagerx-gen GRAPH.yaml` is short for `eagerx-gen generate GRAPH.yaml`. A graph may also be a "
    "file that EAGERx's Graph.save or BaseEnv.save wrote.\n"
    "Exit codes: 0 done, 1 problems found, 2 wrong usage, 3 cannot read or write, 4 a bug in "
    "eagerx-gen.";

void add_generate(CLI::App& app, Options& options) {
  add_graph(app, options);
  add_output(app, options);
  add_selection(app, options);
  add_rates(app, options);
  add_library(app, options);
  add_diagnostics(app, options);
}

void add_check(CLI::App& app, Options& options) {
  add_graph(app, options);
  add_selection(app, options);
  add_rates(app, options);
  add_library(app, options);
  add_diagnostics(app, options);
}

void add_info(CLI::App& app, Options& options) {
  app.add_option("entity", options.entity, "id of an entity or target, or a graph file")
      ->type_name("ENTITY|GRAPH.yaml");
  app.add_option("--engine", options.engine, "run the graph on this engine instead of its own")
      ->type_name("NAME");
  add_rates(app, options);
  add_library(app, options);
  app.add_flag("--json", options.json_output, "print JSON (of graphs)");
}

void add_explain(CLI::App& app, Options& options) {
  app.add_option("code", options.code, "such as E0307 or 307 (default: list all codes)")
      ->type_name("CODE");
}

void add_import(CLI::App& app, Options& options) {
  app.add_option("state", options.graph, "the file that EAGERx saved")
      ->required()
      ->type_name("STATE.yaml");
  app.add_option("-o,--output", options.output, "the graph to write (default: print it)")
      ->type_name("GRAPH.yaml");
  app.add_option("--engine", options.engine, "engine, if the file has none")->type_name("NAME");
  add_rates(app, options);
  add_library(app, options);
  add_diagnostics(app, options);
}

void add_new(CLI::App& app, Options& options) {
  app.require_subcommand(1);
  CLI::App& board = *app.add_subcommand("board", "a board of your own");
  board.add_option("name", options.entity, "its name")->required()->type_name("NAME");
  board.add_option("-o,--output", options.output, "where to make its folder (default: targets)")
      ->type_name("DIR");
  add_diagnostics(board, options);
}

void add_policies(CLI::App& app, Options& options) {
  app.require_subcommand(1);
  add_policy(*app.add_subcommand("info", "layers, size and what it expects of a graph"), options);
  CLI::App& test = *app.add_subcommand("test", "compare its answers with rows that are known");
  add_policy(test, options);
  test.add_option("golden", options.golden, "rows of observations and answers")
      ->required()
      ->type_name("GOLDEN.csv|npz");
}

/// In the order of the help text.
struct Command {
  const char* name;
  const char* about;
  void (*add)(CLI::App& app, Options& options);
  int (*run)(const Options& options);
};
constexpr std::array kCommands = {
    Command{"generate", "write the program of a graph", add_generate,
            eagerx::gen::generate_command},
    Command{"check", "only look for problems", add_check, eagerx::gen::check_command},
    Command{"info", "list entities and targets, or explain one or a graph", add_info,
            eagerx::gen::info_command},
    Command{"explain", "what a code such as E0307 means and what to do, or all codes", add_explain,
            eagerx::gen::explain_command},
    Command{"import", "rewrite a file of EAGERx (Graph.save, BaseEnv.save) as a graph", add_import,
            eagerx::gen::import_command},
    Command{"schema", "print the JSON schema of graph files, for editors",
            [](CLI::App&, Options&) {},
            [](const Options&) { return eagerx::gen::schema_command(); }},
    Command{"new", "make a folder to fill in", add_new, eagerx::gen::new_board_command},
    Command{"size", "flash, RAM, stack and instructions of an image", add_size,
            eagerx::gen::size_command},
    Command{"replay", "repeat the run of a log and find the first difference", add_replay,
            eagerx::gen::replay_command},
    Command{"identify", "find the parameters and delays that a log was made with", add_identify,
            eagerx::gen::identify_command},
    Command{"policy", "look into a trained policy", add_policies, eagerx::gen::policy_command},
};

bool is_command(const std::string& word) {
  return std::any_of(kCommands.begin(), kCommands.end(),
                     [&](const Command& command) { return word == command.name; });
}

/// What is named twice is made once.
void drop_repeats(std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const auto& name : names) {
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  }
  names = std::move(once);
}

int run(std::vector<std::string> arguments) {
  Options options;
  CLI::App app("Checks an EAGERx graph and writes a C++ program for it.", "eagerx-gen");
  app.footer(kFooter);
  app.set_version_flag("--version", "eagerx-gen " EAGERX_GEN_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App* failed, const CLI::Error& problem) {
    return eagerx::gen::usage_message(*failed, problem);
  });
  for (const Command& command : kCommands)
    command.add(*app.add_subcommand(command.name, command.about), options);
  const std::string first = arguments.empty() ? std::string("-") : arguments.front();
  if (!first.starts_with('-') && !is_command(first)) {
    if (const std::string problem = eagerx::gen::not_a_command(app, first); !problem.empty()) {
      std::fputs(problem.c_str(), stderr);
      return eagerx::gen::kWrongUsage;
    }
    arguments.insert(arguments.begin(), "generate");
  }
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? eagerx::gen::kDone : eagerx::gen::kWrongUsage;
  }
  const auto parsed = std::find_if(kCommands.begin(), kCommands.end(), [&](const Command& command) {
    return app.got_subcommand(command.name);
  });
  drop_repeats(options.targets);
  drop_repeats(options.packages);
  return parsed->run(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr,
                 "error: this is a bug in eagerx-gen: %s\nhelp: please report it with the graph\n",
                 error.what());
    return eagerx::gen::kInternal;
  }
}

// eagerx-gen linearize: the sampled loop of a graph as it runs. A program of target linearize steps
// the graph over numbers with derivatives; what follows from its matrices is tools/linear.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <runtime/host/base/nearest.hpp>
#include <string>
#include <vector>

#include "generator/analysis/info/info.hpp"
#include "generator/driver/build/built.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/support/process/process.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/linear/write.hpp"

namespace eagerx::gen {
namespace {

enum class LinearFormat : std::uint8_t { text, json, csv };

struct LinearizeOptions : GenerateOptions {
  std::vector<std::string> at, from, to;
  std::string open;
  std::optional<std::uint64_t> steps, seed;
  LinearFormat format = LinearFormat::text;
};

std::size_t channel_at(const Plan& plan, std::size_t node, std::size_t output) {
  const auto found = std::ranges::find_if(plan.channels, [&](const Channel& each) {
    return each.node == node && each.output == output;
  });
  return static_cast<std::size_t>(found - plan.channels.begin());
}

/// A name of what a channel carries.
struct PortName {
  std::string name;
  std::size_t channel;
};
/// All ports that send, and then those that receive, which stand for what they get.
std::vector<PortName> port_names(const Plan& plan) {
  std::vector<PortName> names;
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    const Channel& channel = plan.channels[c];
    if (plan.graph->nodes[channel.node].role == NodeRole::engine) continue;
    names.push_back({channel.port, c});
    for (const std::string& alias : channel.aliases) names.push_back({alias, c});
    names.push_back({channel.name, c});
  }
  for (const GraphNode& node : plan.graph->nodes) {
    for (const Input& input : node.inputs) {
      const std::size_t channel = channel_at(plan, input.source_node, input.source_output);
      // What only pictures need has none.
      if (channel < plan.channels.size()) names.push_back({input.written, channel});
    }
  }
  return names;
}

/// The channel of a port; nothing with a problem.
std::optional<std::size_t> channel_of(const std::string& port, const Plan& plan,
                                      Diagnostics& diagnostics) {
  const std::vector<PortName> all = port_names(plan);
  const auto find = [&](const std::string& name) -> std::optional<std::size_t> {
    const auto found = std::ranges::find(all, name, &PortName::name);
    return found != all.end() ? std::optional(found->channel) : std::nullopt;
  };
  if (const auto channel = find(port)) return channel;
  std::vector<std::string> names;
  for (const PortName& each : all) names.push_back(each.name);
  if (const std::string* const meant = host::name_meant(port, names)) {
    diagnostics.note(plan.graph->span, fmt::format("`{}` is `{}` here", port, *meant));
    return find(*meant);
  }
  diagnostics.error("E0520", plan.graph->span, fmt::format("nothing sends `{}`", port)).help =
      suggestion(port, names);
  return std::nullopt;
}

/// Where a loop is opened.
struct OpenedPort {
  std::size_t channel = 0;
  std::uint64_t element = 0;
};
/// "motor.y[2]" or, of a message of one number, "motor.u"; nothing with a problem.
std::optional<OpenedPort> opened_port(const std::string& text, const Plan& plan,
                                      Diagnostics& diagnostics) {
  // Elements of arrays of nodes have an index too: "leg[2].u".
  const std::size_t bracket = text.ends_with(']') ? text.rfind('[') : std::string::npos;
  const auto channel = channel_of(text.substr(0, bracket), plan, diagnostics);
  if (!channel) return std::nullopt;
  const Channel& sent = plan.channels[*channel];
  const Span& span = plan.graph->span;
  if (sent.node == Graph::kEnvironment) {
    diagnostics
        .error("E0520", span,
               fmt::format("no loop goes through `{}`: the derivatives are those without an agent",
                           text))
        .help = "open the loop at what a node or a sensor sends";
    return std::nullopt;
  }
  const std::uint64_t size = plan.graph->nodes[sent.node].outputs[sent.output].space.size();
  OpenedPort port{*channel, 0};
  if (bracket == std::string::npos && size == 1) return port;
  const auto index = bracket == std::string::npos
                         ? std::nullopt
                         : parse_int(text.substr(bracket + 1, text.size() - bracket - 2));
  if (index && *index >= 0 && static_cast<std::uint64_t>(*index) < size) {
    port.element = static_cast<std::uint64_t>(*index);
    return port;
  }
  diagnostics
      .error("E0520", span,
             fmt::format("a loop is opened at one number, and `{}` has {}", sent.port, size))
      .help = size == 1 ? fmt::format("write `{}`", sent.port)
                        : fmt::format("write `{0}[0]` to `{0}[{1}]`", sent.port, size - 1);
  return std::nullopt;
}

/// What cannot be linearized, at its place.
bool check_graph(const Graph& graph, Diagnostics& diagnostics) {
  if (graph.placement)
    diagnostics.error("E0520", graph.span, "a graph with parts cannot be linearized").help =
        "linearize a variant without `placement:`";
  if (graph.has_reset_nodes())
    diagnostics.error("E0520", graph.span, "a graph with reset nodes cannot be linearized");
  return !diagnostics.has_errors();
}

/// Steps until every window is full and every delay has passed.
std::uint64_t steps_until_full(const Plan& plan) {
  const Graph& graph = *plan.graph;
  double longest_s = 0.0;
  for (const GraphNode& node : graph.nodes) {
    for (const Input& input : node.inputs) {
      const double source_hz = graph.nodes[input.source_node].rate_hz.to_double();
      const Rational delay = input.max_delay_s ? *input.max_delay_s : input.delay_s;
      longest_s = std::max(longest_s, delay.to_double() + (input.window + 1) / source_hz);
    }
  }
  constexpr double kMost = 1e6;
  return static_cast<std::uint64_t>(
      std::min(kMost, 2.0 * longest_s * graph.environment().rate_hz.to_double() + 2.0));
}

/// The words for the program; nothing with a problem.
std::optional<std::vector<std::string>> words_of(const LinearizeOptions& options, const Plan& plan,
                                                 std::optional<OpenedPort>& opened,
                                                 Diagnostics& diagnostics) {
  std::vector<std::string> words = {
      "--steps", fmt::format("{}", options.steps.value_or(steps_until_full(plan))), "--seed",
      fmt::format("{}", options.seed.value_or(1))};
  for (const std::string& state : options.at) words.insert(words.end(), {"--at", state});
  const auto add = [&](const char* name, std::size_t channel) {
    words.insert(words.end(), {name, fmt::format("{}", channel)});
  };
  const auto add_ports = [&](const char* name, const std::vector<std::string>& ports) {
    for (const std::string& port : ports) {
      if (const auto channel = channel_of(port, plan, diagnostics)) add(name, *channel);
    }
  };
  add_ports("--from", options.from);
  add_ports("--to", options.to);
  if (!options.open.empty()) {
    opened = opened_port(options.open, plan, diagnostics);
    if (opened) {
      add("--open", opened->channel);
      add("--element", opened->element);
    }
  }
  if (diagnostics.has_errors()) return std::nullopt;
  const GraphNode& environment = plan.graph->environment();
  for (std::size_t a = 0; options.from.empty() && a < environment.outputs.size(); ++a)
    add("--from", channel_at(plan, Graph::kEnvironment, a));
  for (std::size_t i = 0; options.to.empty() && i < environment.inputs.size(); ++i)
    add("--to",
        channel_at(plan, environment.inputs[i].source_node, environment.inputs[i].source_output));
  return words;
}

/// Ages of data that go through the opened port.
std::vector<DataAge> ages_through(const Plan& plan, std::size_t channel, const PlanInfo& info) {
  std::vector<DataAge> result;
  for (const DataAge& age : info.ages) {
    const bool passes = std::ranges::any_of(age.way, [&](const AgeHop& hop) {
      return std::ranges::any_of(plan.graph->nodes, [&](const GraphNode& node) {
        return std::ranges::any_of(node.inputs, [&](const Input& input) {
          return input.written == hop.input && input.source_node == plan.channels[channel].node &&
                 input.source_output == plan.channels[channel].output;
        });
      });
    });
    if (passes) result.push_back(age);
  }
  return result;
}

int print(Run& run, const LinearizeOptions& options, const SampledSystem& system,
          const std::optional<OpenedPort>& opened) {
  LinearReport report{&system, modes_of(system), {}, options.open, {}};
  if (opened) {
    if (system.opened == 0) {
      run.diagnostics.error("E0520", run.graph->span,
                            fmt::format("`{}` has no numbers with derivatives", options.open));
      return finish(run, options);
    }
    report.margins = margins_of(system);
    report.ages = ages_through(*run.plan, opened->channel,
                               info_of(*run.plan, run.spec->budget, run.diagnostics));
  }
  if (options.format == LinearFormat::text) say_text(linear_text(report));
  if (options.format == LinearFormat::json) say_text(dump_json(linear_json(report)) + "\n");
  if (options.format == LinearFormat::csv) say_text(response_csv(system));
  return kDone;
}

int perform(const LinearizeOptions& given) {
  LinearizeOptions options = given;
  options.targets = {"linearize"};
  options.purpose = Purpose::simulation;
  Run run;
  int code = kDone;
  if (!make(run, options) || !check_graph(*run.graph, run.diagnostics)) return finish(run, options);
  std::optional<OpenedPort> opened;
  const auto words = words_of(options, *run.plan, opened, run.diagnostics);
  const auto built = words ? build_made_graph(run, options, code) : std::nullopt;
  if (!built) return std::max(code, finish(run, options));
  std::vector<std::string> command = {absolute_path(built->back().image).string()};
  command.insert(command.end(), words->begin(), words->end());
  const auto result = run_process(command);
  if (!result || result->exit_code != 0) {
    complain_text(result ? result->output : "error: the program could not be started\n");
    const bool has_problem = result && result->exit_code == kProblems;
    return std::max(finish(run, options), has_problem ? int{kProblems} : int{kWrongUsage});
  }
  const auto system = read_system(result->output, *run.plan);
  if (!system) {
    run.diagnostics.error("E0520", run.graph->span, "the program has printed no matrices");
    return finish(run, options);
  }
  code = print(run, options, *system, opened);
  return code != kDone ? code : finish(run, options);
}

std::string check(const LinearizeOptions& options) {
  return options.format == LinearFormat::csv && options.open.empty()
             ? "`--format csv` is the frequency response of a loop: it needs `--open PORT`"
             : "";
}

Command table(LinearizeOptions& options) {
  return {
      .name = "linearize",
      .about =
          "linearize the sampled loop as it runs, with its rates, delays and windows: matrices, "
          "poles, and stability margins",
      .examples = {{"matrices and poles where the graph starts", "eagerx-gen linearize robot.yaml"},
                   {"gain, phase and delay margin of the loop through a motor",
                    "eagerx-gen linearize robot.yaml --open controller.u"},
                   {"at another state, from a setpoint to a sensor, for NumPy",
                    "eagerx-gen linearize robot.yaml --at pendulum.model_state=0,0 --from target.y "
                    "--to pendulum.theta --format json"}},
      .arguments = joined(
          {{graph(options),
            text("--open", options.open,
                 "break the loop at this port, and print its stability margins", "PORT"),
            texts("--at", options.at,
                  "initial state, its elements separated by commas (default: that of the graph)",
                  "STATE=VALUE"),
            whole("--steps", options.steps,
                  "steps without an action before the operating point (default: until windows are "
                  "full and delays have passed)",
                  0, 1'000'000'000),
            whole("--seed", options.seed, "seed of random numbers (default: 1)", 0,
                  std::numeric_limits<std::int64_t>::max()),
            texts("--from", options.from,
                  "ports as inputs: an offset of their messages (default: the actions)", "PORT"),
            texts("--to", options.to, "ports as outputs (default: the observations)", "PORT"),
            choice("--format", {"text", "json", "csv"},
                   "text, JSON with all matrices, or with --open the frequency response as a table "
                   "(default: text)",
                   [&options](const std::string& name) {
                     options.format = name == "json"  ? LinearFormat::json
                                      : name == "csv" ? LinearFormat::csv
                                                      : LinearFormat::text;
                   }),
            folder(text(
                "-o,--output", options.output,
                "folder for the program (default: generated/<graph name>-linearize, followed by "
                "the name of a variant or engine)",
                "DIR"))},
           {variant(options), engine(options)},
           rates(options),
           {library(options), warnings(options)},
           diagnostics(options)}),
      .check = [&options] { return check(options); },
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command linearize_command() {
  return with_options<LinearizeOptions>(table);
}

}  // namespace eagerx::gen

// eagerx-gen linearize: the sampled loop of a graph as it runs. A program of target linearize steps
// the graph over numbers with derivatives; what follows from its matrices is tools/linear.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/tools/commands/design_write.hpp"
#include "generator/tools/commands/linear_program.hpp"
#include "generator/tools/commands/opened_loop.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/commands/trim_point.hpp"
#include "generator/tools/linear/export.hpp"
#include "generator/tools/linear/loop_svg.hpp"
#include "generator/tools/linear/write.hpp"

namespace eagerx::gen {
namespace {

enum class LinearFormat : std::uint8_t { text, json, csv, yaml };

struct LinearizeOptions : LinearOptions {
  std::vector<std::string> from, to;
  std::string open, plot, npz;
  double step = 0.0;  // of --plot; 0: chosen
  bool trim = false, corners = false;
  TrimSettings point;  // of --trim
  LinearFormat format = LinearFormat::text;
};

/// The words for the program; nothing with a problem.
std::optional<std::vector<std::string>> words_of(const LinearizeOptions& options, const Plan& plan,
                                                 std::optional<PortElement>& opened,
                                                 Diagnostics& diagnostics) {
  std::vector<std::string> words = first_words(options, plan);
  for (const std::string& state : options.at) {
    if (options.trim) break;  // the search begins there
    check_state(state, *plan.graph, diagnostics);
    words.insert(words.end(), {"--at", state});
  }
  const auto add = [&](const char* name, std::size_t channel) {
    words.insert(words.end(), {name, fmt::format("{}", channel)});
  };
  const auto add_ports = [&](const char* name, const std::vector<std::string>& ports) {
    for (const std::string& port : ports) {
      if (const auto channel = channel_of(port, name, plan, diagnostics)) add(name, *channel);
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
  for (std::size_t a = 0; options.from.empty() && a < environment.outputs.size(); ++a) {
    if (!is_floating(environment.outputs[a].space.dtype))
      diagnostics.note(plan.graph->span, fmt::format("`actions.{}` is not an input: it is {}",
                                                     environment.outputs[a].name,
                                                     environment.outputs[a].space.describe()));
    add("--from", channel_at(plan, Graph::kEnvironment, a));
  }
  for (std::size_t i = 0; options.to.empty() && i < environment.inputs.size(); ++i)
    add("--to",
        channel_at(plan, environment.inputs[i].source_node, environment.inputs[i].source_output));
  return words;
}

/// A system, and what the program was asked for it.
struct Linearized {
  std::string image;
  std::vector<std::string> words;
  SampledSystem system;
};

/// The system as a node of a graph.
int print_node(Run& run, const LinearizeOptions& options, const LinearReport& report) {
  std::string problem;
  const std::string text = state_space_yaml(report, problem);
  if (problem.empty())
    say_text(text);
  else
    run.diagnostics.error("E0520", run.graph->span, problem);
  return finish(run, options);
}

/// Bounds as in Space; null for none.
Json bound_json(const std::vector<double>& bounds, std::size_t i) {
  if (bounds.empty()) return nullptr;
  const double bound = bounds[bounds.size() == 1 ? 0 : i];
  return std::isfinite(bound) ? Json(bound) : Json(nullptr);
}

bool is_tunable(const Config& config, const std::string& name) {
  return std::ranges::any_of(config, [&](const ConfigValue& each) {
    return each.parameter->name.value == name && each.parameter->tunable;
  });
}

/// The tunable parameters of an object or a node that `there` does not list: a program prints the
/// states that a reset sets, and these keep the values of the graph until `--at` sets them.
template <class Owner>
void add_tunable(Json& list, const Owner& owner, const Hyperperiod& there) {
  const auto& listed = *list.as<Json::List>();
  for (const State& state : owner.states) {
    const std::string name = owner.name + "." + state.name;
    const std::vector<double> written = parameter_of(owner.config, state.name);
    const bool is_listed = std::ranges::any_of(
        listed, [&](const Json& each) { return text_of(member(&each, "name")) == name; });
    if (!state.settable || is_listed || written.empty() || !is_tunable(owner.config, state.name))
      continue;
    Json values = Json::list(), low = Json::list(), high = Json::list();
    for (std::size_t i = 0; i < written.size(); ++i) {
      const auto set = std::ranges::find_if(there.states, [&](const ResetElement& each) {
        return each.state == name && each.element == i;
      });
      values.push_back(set != there.states.end() ? set->value : written[i]);
      low.push_back(bound_json(state.space.low, i));
      high.push_back(bound_json(state.space.high, i));
    }
    list.push_back(Json{{"name", name},
                        {"values", std::move(values)},
                        {"low", std::move(low)},
                        {"high", std::move(high)}});
  }
}

/// The loop for the page of `serve`, and the parameters that its sliders set.
std::optional<std::string> page_text(Run& run, const Linearized& at, const LoopCurves& curves,
                                     const LinearReport& report, int& code) {
  std::vector<std::string> words = at.words;
  words.insert(words.end(), {"--compares", "0"});
  const auto there = hyperperiod_of(run, at.image, words, code);
  if (!there) return std::nullopt;
  Json json = loop_page_json(curves, report);
  Json parameters = parameters_json(*there);
  for (const Object& each : run.graph->objects) add_tunable(parameters, each, *there);
  for (const GraphNode& each : run.graph->nodes) add_tunable(parameters, each, *there);
  json["parameters"] = std::move(parameters);
  return dump_json(json) + "\n";
}

/// Draws the loop; false with a problem.
bool plot(Run& run, const LinearizeOptions& options, const Linearized& at,
          const PortElement& opened, const LinearReport& report, int& code) {
  const auto curves =
      loop_curves_of_program(run, at.image, at.words, opened, options.step, report, code);
  if (!curves) return false;
  if (!options.plot.ends_with(".json"))
    return write_file(options.plot, loop_svg(*curves, run.graph->name), run.diagnostics);
  const auto text = page_text(run, at, *curves, report, code);
  return text && write_file(options.plot, *text, run.diagnostics);
}

int print(Run& run, const LinearizeOptions& options, const Linearized& at,
          const std::optional<PortElement>& opened, const std::optional<WorstMargins>& corners) {
  const SampledSystem& system = at.system;
  int code = kDone;
  LinearReport report{&system, modes_of(system), {}, options.open, {}, corners};
  if (opened && !add_loop(run, *opened, report)) return finish(run, options);
  if (!options.plot.empty() && !plot(run, options, at, *opened, report, code))
    return std::max(code, finish(run, options));
  if (!options.npz.empty() && !write_file(options.npz, linear_npz(report), run.diagnostics))
    return finish(run, options);
  if (options.format == LinearFormat::yaml) return print_node(run, options, report);
  if (options.format == LinearFormat::text) say_text(linear_text(report));
  if (options.format == LinearFormat::json) say_text(dump_json(linear_json(report)) + "\n");
  if (options.format == LinearFormat::csv) say_text(response_csv(system));
  return kDone;
}

/// The system that the program has with these words, with `--trim` where the graph rests; nothing
/// with a problem.
std::optional<Linearized> system_at(Run& run, const std::string& image,
                                    const LinearizeOptions& options, std::vector<std::string> words,
                                    int& code) {
  if (options.trim) {
    const auto point = trim_point(run, image, options.point, options, code);
    if (!point || !point->answer.found) return std::nullopt;
    const auto there = words_at(*point);
    words.insert(words.end(), there.begin(), there.end());
  }
  auto system = system_of(run, image, words, code);
  if (!system) return std::nullopt;
  return Linearized{image, std::move(words), std::move(*system)};
}

/// The worst margins over the corners of what a reset samples; nothing with a problem.
std::optional<WorstMargins> worst_of_corners(Run& run, const std::string& image,
                                             const LinearizeOptions& options,
                                             const std::vector<std::string>& words, int& code) {
  std::vector<std::string> asked = words;
  asked.insert(asked.end(), {"--compares", "0"});
  const auto there = hyperperiod_of(run, image, asked, code);
  const auto corners = there ? corners_of(*there) : std::nullopt;
  if (!corners) {
    if (there)
      run.diagnostics
          .error("E0520", run.graph->span,
                 fmt::format("a reset samples {} parameters, and `--corners` takes at most 8",
                             sampled_parameters(*there).size()))
          .help = "give some a value in a variant, or use a campaign";
    return std::nullopt;
  }
  WorstMargins worst;
  for (const Corner& corner : *corners) {
    LinearizeOptions there_options = options;
    there_options.at.insert(there_options.at.end(), corner.begin(), corner.end());
    std::vector<std::string> there_words = words;
    for (const std::string& state : corner) there_words.insert(there_words.end(), {"--at", state});
    const auto at = system_at(run, image, there_options, there_words, code);
    if (!at || at->system.opened == 0) return std::nullopt;
    worst.take(margins_of(at->system), corner);
  }
  return worst;
}

int perform(const LinearizeOptions& given) {
  LinearizeOptions options = given;
  Run run;
  int code = kDone;
  if (!make_linear_graph(run, options)) return finish(run, options);
  for (const std::string& path : {options.plot, options.npz}) {
    if (!path.empty() && !spares_inputs(path, run.diagnostics)) return finish(run, options);
  }
  std::optional<PortElement> opened;
  auto words = words_of(options, *run.plan, opened, run.diagnostics);
  if (options.trim && !check_trim(options.point, options, *run.plan, run.diagnostics))
    words.reset();
  const auto image = words ? build_linear_program(run, options, code) : std::nullopt;
  if (!image) return std::max(code, finish(run, options));
  const auto at = system_at(run, *image, options, *words, code);
  const auto corners =
      at && options.corners ? worst_of_corners(run, *image, options, *words, code) : std::nullopt;
  if (!at || (options.corners && !corners)) return std::max(finish(run, options), code);
  code = print(run, options, *at, opened, corners);
  return code != kDone ? code : finish(run, options);
}

std::optional<double> size_of_step(const std::string& text) {
  const auto size = parse_number(text);
  return size && std::isfinite(*size) && *size != 0.0 ? size : std::nullopt;
}

std::string check(const LinearizeOptions& options) {
  if (!options.plot.empty() && options.open.empty())
    return "`--plot` draws a loop: it needs `--open PORT`";
  if (options.step != 0.0 && options.plot.empty())
    return "`--step-size` is the size of the step in the picture: it needs `--plot FILE.svg`";
  const TrimSettings& point = options.point;
  if (!options.trim && !(point.fix.empty() && point.moving.empty() && point.bounds.empty()))
    return "`--fix`, `--moving` and `--bounds` are for the search of `--trim`";
  if (options.corners && options.open.empty())
    return "`--corners` varies the margins of a loop: it needs `--open PORT`";
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
      .examples = {{"matrices and poles at the start of an episode",
                    "eagerx-gen linearize robot.yaml"},
                   {"gain, phase and delay margin of the loop through a motor",
                    "eagerx-gen linearize robot.yaml --open controller.u"},
                   {"the same, with plots",
                    "eagerx-gen linearize robot.yaml --open controller.u --plot loop.svg"},
                   {"at another state, from a setpoint to a sensor, for NumPy",
                    "eagerx-gen linearize robot.yaml --at pendulum.model_state=0,0 --from target.y "
                    "--to pendulum.theta --npz plant.npz"},
                   {"at the operating point with the pendulum at 0.1 rad",
                    "eagerx-gen linearize robot.yaml --trim --fix 'pendulum.model_state[0]=0.1'"}},
      .arguments = joined(
          {{graph(options),
            text("--open", options.open,
                 "open the loop at this port, and print its stability margins", "PORT"),
            writes(text("--plot", options.plot,
                        "with --open: draw Bode and Nyquist plots, poles and the step response; "
                        "FILE.json gets their numbers, and the parameters that --at can set",
                        "FILE.svg")),
            checked(
                {"--step-size",
                 "with --plot: size of the step that the program simulates, in the unit of the "
                 "port (default: 5 % of the range of the port, or 1 if it has none)",
                 "SIZE",
                 [&options](const auto& values) { options.step = *size_of_step(values.front()); }},
                [](const std::string& word) { return size_of_step(word).has_value(); },
                "is no number other than 0"),
            writes(text("--npz", options.npz,
                        "write all matrices, names and poles as arrays for numpy.load()",
                        "FILE.npz")),
            flag("--corners", options.corners,
                 "also print the worst margins over all combinations of the least and largest "
                 "values of parameters and delays that a reset samples"),
            texts("--at", options.at,
                  "initial state, its elements separated by commas (default: that of the graph)",
                  "STATE=VALUE"),
            flag("--trim", options.trim,
                 "linearize at the operating point that `eagerx-gen trim` finds with these --at, "
                 "--fix, --moving and --bounds")},
           trim_arguments(options.point),
           {whole("--steps", options.steps,
                  "steps without an action before the operating point (default: until windows are "
                  "full and delays have passed, with steady covariances)",
                  0, 1'000'000'000),
            whole("--seed", options.seed, "seed of random numbers (default: 1)", 0,
                  std::numeric_limits<std::int64_t>::max()),
            texts("--from", options.from,
                  "inputs u: ports whose messages get an offset (default: the actions)", "PORT"),
            texts("--to", options.to, "outputs y: ports (default: the observations)", "PORT"),
            choice("--format", {"text", "json", "csv", "yaml"},
                   "text, JSON with all matrices, with --open the frequency response as a table, "
                   "or a node StateSpace for a graph (default: text)",
                   [&options](const std::string& name) {
                     options.format = name == "json"   ? LinearFormat::json
                                      : name == "csv"  ? LinearFormat::csv
                                      : name == "yaml" ? LinearFormat::yaml
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
  return experimental(with_options<LinearizeOptions>(table));
}

}  // namespace eagerx::gen

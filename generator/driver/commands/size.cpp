// eagerx-gen size: measures the resources of an image, and checks the graph's budget.
#include "generator/analysis/size/size.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "generator/analysis/info/info.hpp"
#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/analysis/size/tools.hpp"
#include "generator/driver/build/built.hpp"
#include "generator/driver/build/library_project.hpp"
#include "generator/driver/build/targets.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/check_targets.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/image_budget.hpp"
#include "generator/driver/commands/image_time.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct SizeOptions : GenerateOptions {
  std::string image, build, baseline;  // files and the build folder; empty: none, the image's
  std::string run_on;                  // a target; empty: nothing is run
  bool json_output = false;
  bool worst = false;
};

/// Runs the image in the target's emulator, where an instruction lasts 2^shift ns.
std::optional<Instructions> count_instructions(const Run& run, const SizeOptions& options) {
  constexpr int kShift = 5;
  constexpr double kNsPerInstruction = 1 << kShift;
  constexpr double kNsPerSecond = 1e9;
  Instructions result;
  double hz = 0, sum = 0, least = 0, most = 0;
  const auto value = [](const std::string& line, std::string_view name, double& number) {
    if (line.starts_with(name)) number = std::strtod(line.c_str() + name.size(), nullptr);
  };
  double slots = 0;
  const int code =
      for_each_line({"env", fmt::format("EAGERX_EMULATOR_OPTIONS=-icount shift={}", kShift),
                     (fs::path(run.root) / "targets" / "run").string(), options.run_on,
                     options.image, "--timing"},
                    [&](std::string_view view) {
                      const std::string line(view);
                      value(line, "clock ", hz);
                      value(line, "slots ", slots);
                      value(line, "busy least ", least);
                      value(line, "busy most ", most);
                      value(line, "busy sum ", sum);
                    });
  if (code != 0 || hz <= 0 || slots <= 0) return std::nullopt;
  const double instructions_per_tick = kNsPerSecond / hz / kNsPerInstruction;
  result.slots = static_cast<std::uint64_t>(slots);
  result.least = static_cast<std::uint64_t>(std::llround(least * instructions_per_tick));
  result.most = static_cast<std::uint64_t>(std::llround(most * instructions_per_tick));
  result.mean = sum * instructions_per_tick / slots;
  return result;
}

/// Nothing without --baseline.
std::optional<Json> read_baseline(Run& run, const SizeOptions& options) {
  if (options.baseline.empty()) return std::nullopt;
  std::ifstream file(options.baseline);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  auto json = parse_json(text);
  if (!json || !json->is<Json::Object>()) {
    run.diagnostics.io_error("E0911", {}, fmt::format("cannot read `{}`", options.baseline)).help =
        "give what `eagerx-gen size --json` printed";
    return std::nullopt;
  }
  return json;
}

/// `worst`: of `--worst`, or of a budget for the time of slots.
void print_report(const SizeReport& report, const std::optional<PlanInfo>& plan,
                  const std::optional<ImageTime>& worst, bool as_json) {
  if (!as_json) {
    say("{}{}{}", size_text(report), worst ? time_text(*worst) : "",
        plan ? timing_text(*plan) : "");
    return;
  }
  Json json = size_json(report);
  if (worst) json["worst"] = time_json(*worst, true);
  if (plan) {
    Json timing = info_json(*plan);
    json["ages"] = std::move(timing["ages"]);
    json["budget_ages"] = std::move(timing["budget_ages"]);
    json["link"] = std::move(timing["link"]);
  }
  say("{}\n", dump_json(json));
}

bool is_yaml(const std::string& path) {
  return path.ends_with(".yaml") || path.ends_with(".yml");
}

/// The least program around the library of `--of`, for the board of `--target`.
std::optional<BuiltProgram> build_least(Run& run, const SizeOptions& options, int& code) {
  GenerateOptions library = options;
  const std::string folder =
      folder_for_options("generated/" + fs::path(options.graph).stem().string() + "-size", options);
  library.output = folder + "/library";
  const auto generated = make(run, library) ? generate_graph(run, library, code) : std::nullopt;
  if (!generated) return std::nullopt;
  const Target& target = *run.library.find_target(wanted_targets(options).front());
  return build_library_project(run, options, target, "size", folder);
}

/// Leaves out what a user's main loop adds to the library's memory.
void leave_out_board(SizeReport& report) {
  const Usage board = report.others["board"];
  report.flash -= board.flash;
  report.ram -= board.ram;
  report.others.erase("board");
}

/// `size GRAPH.yaml --of NODE --target BOARD`: what the least program takes without its board.
int perform_library(SizeOptions options) {
  Run run;
  int code = kDone;
  options.graph = options.image;
  const auto baseline = read_baseline(run, options);
  if (run.diagnostics.has_errors()) return finish(run, options);
  const auto program = build_least(run, options, code);
  auto report =
      program ? measure_image(program->image, program->build, run.diagnostics) : std::nullopt;
  if (!report) return std::max(finish(run, options), code);
  leave_out_board(*report);
  if (!options.quiet) print_report(*report, std::nullopt, std::nullopt, options.json_output);
  check_library_budget(run, options, {*report, baseline, "the library", std::nullopt});
  return std::max(finish(run, options), code);
}

/// Whether the bound is asked for, by `--worst` or by the graph's budget.
bool wants_bound(const Run& run, const SizeOptions& options) {
  const bool has_budget = run.plan && options.of.empty() && run.spec->budget;
  return options.worst || (has_budget && limits_time(*run.spec->budget));
}

/// `size IMAGE.elf`.
int perform_image(const SizeOptions& options) {
  Run run;
  run.root = data_root();
  std::optional<PlanInfo> plan;
  const bool made = !options.graph.empty() && make(run, options);
  if (made && !options.of.empty()) {
    if (!check_targets(run, options)) return finish(run, options);
  } else if (made) {
    plan = info_of(*run.plan, run.spec->budget, run.diagnostics);
    allow_warnings(run.spec->allow, false, run.diagnostics);
  }
  const std::optional<Json> baseline = read_baseline(run, options);
  if (run.diagnostics.has_errors()) return finish(run, options);
  auto report =
      measure_image(options.image, build_folder_of(options.image, options.build), run.diagnostics);
  if (!report) return finish(run, options);
  if (!options.run_on.empty()) {
    report->instructions = count_instructions(run, options);
    if (!report->instructions)
      run.diagnostics.io_error(
          "E0911", {}, fmt::format("cannot run `{}` on `{}`", options.image, options.run_on));
  }
  std::optional<ImageTime> worst;
  if (wants_bound(run, options)) {
    worst = time_of_image(run, options, options.image, options.of.empty(), run.diagnostics);
    if (!worst) return finish(run, options);
  }
  if (!options.quiet) print_report(*report, plan, worst, options.json_output);
  const MeasuredImage image{*report, baseline, "the image", std::nullopt};
  if (!options.of.empty()) {
    check_library_budget(run, options, image);
  } else if (plan && run.spec->budget) {
    check_image_budget(image, *run.spec->budget, run.diagnostics);
    check_plan_budget(*plan, *run.spec->budget, run.diagnostics);
    if (worst)
      check_time_budget(worst->bound, worst->fit, *run.plan, *run.spec->budget, run.diagnostics);
  }
  return finish(run, options);
}

int perform(const SizeOptions& options) {
  return is_yaml(options.image) ? perform_library(options) : perform_image(options);
}

std::string check(const SizeOptions& options) {
  if (!is_yaml(options.image)) {
    if (!options.targets.empty()) return "--target is for a graph; an image was built for one";
    return options.of.empty() || !options.graph.empty()
               ? ""
               : "--of needs the graph of the image: --graph GRAPH.yaml";
  }
  if (options.of.empty())
    return "a graph has no size: name nodes with --of, to measure their library, or give an image";
  if (options.targets.size() != 1)
    return "the size of a library is that for a board: name one with --target";
  if (!options.graph.empty()) return "--graph is for an image; the graph is given instead of one";
  if (options.worst) return "--worst bounds the instructions of an image, not of a library";
  return options.run_on.empty() ? "" : "--run counts instructions of an image, not of a library";
}

Command table(SizeOptions& options) {
  return {
      .name = "size",
      .about =
          "measure flash, RAM, stack and instructions of an image, or of a library for a board",
      .examples = {{"flash and RAM of each node", "eagerx-gen size build/pendulum.elf"},
                   {"check a graph's budget and count instructions in the emulator",
                    "eagerx-gen size build/pendulum.elf --graph pendulum.yaml --run mps2-an386"},
                   {"the controller of a graph that also has a plant, as a library for a board",
                    "eagerx-gen size robot.yaml --of controller --target mps2-an386"},
                   {"an image of your own main loop with this library, against the graph's budget",
                    "eagerx-gen size build/robot.elf --graph robot.yaml --of controller"}},
      .arguments = joined(
          {{required(reads(
                text("image", options.image,
                     "image to measure, or, with --of, a graph whose library is built and measured",
                     "IMAGE.elf|GRAPH.yaml"))),
            reads(text("--graph", options.graph,
                       "also check the image against the `budget:` of this graph", "GRAPH.yaml")),
            cut_out_nodes(options,
                          "measure only the library of these nodes, composites or arrays, as for "
                          "generate --of; for an image, check their part of the budget"),
            texts("--target", options.targets, "board to build the library for", "NAME"),
            folder(text("--build", options.build,
                        "build folder of the image (default: the image's folder)", "DIR")),
            variant(options),
            text("--engine", options.engine, "engine of the image, if it is not the graph's",
                 "NAME"),
            library(options),
            experimental(flag(
                "--worst", options.worst,
                "also compute upper bounds from the image: instructions of each step, slot and "
                "node (Cortex-M), cycles (Cortex-M3, M4), and with --graph whether slots fit into "
                "their time. A loop without a bound is error E0427: limit it with "
                "eagerx::bounded<N>()")),
            text("--run", options.run_on,
                 "also run the image in this target's emulator, and count instructions", "TARGET"),
            reads(text(
                "--baseline", options.baseline,
                "previous output of --json: if the budget is exceeded, list the parts that grew",
                "FILE.json")),
            flag("--json", options.json_output, "print JSON")},
           diagnostics(options)}),
      .check = [&options] { return check(options); },
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command size_command() {
  return with_options<SizeOptions>(table);
}

}  // namespace eagerx::gen

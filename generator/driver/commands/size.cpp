// eagerx-gen size: what an image takes, and whether that is within the graph's budget.
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

#include "generator/analysis/bound/bound.hpp"
#include "generator/analysis/info/info.hpp"
#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/analysis/size/tools.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/image_budget.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct SizeOptions : GraphOptions {
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

/// Of the graph's rates, in the order of the bits of a slot.
std::vector<std::string> rate_names(const Run& run) {
  std::vector<std::string> names;
  if (!run.plan) return names;
  for (const RateClass& rate : run.plan->rates) names.push_back(rate.rate_hz.to_string() + " Hz");
  return names;
}

void print_report(const SizeReport& report, const std::optional<PlanInfo>& plan,
                  const std::optional<BoundReport>& bound, bool as_json) {
  if (!as_json) {
    say("{}{}{}", size_text(report), bound ? bound_text(*bound) : "",
        plan ? timing_text(*plan) : "");
    return;
  }
  Json json = size_json(report);
  if (bound) json["worst"] = bound_json(*bound);
  if (plan) {
    Json timing = info_json(*plan);
    json["ages"] = std::move(timing["ages"]);
    json["budget_ages"] = std::move(timing["budget_ages"]);
    json["link"] = std::move(timing["link"]);
  }
  say("{}\n", dump_json(json));
}

int perform(const SizeOptions& options) {
  Run run;
  run.root = data_root();
  std::optional<PlanInfo> plan;
  if (!options.graph.empty() && make(run, options)) {
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
  std::optional<BoundReport> bound;
  if (options.worst) {
    bound = bound_instructions(options.image, rate_names(run), run.diagnostics);
    if (!bound) return finish(run, options);
  }
  if (!options.quiet) print_report(*report, plan, bound, options.json_output);
  if (plan && run.spec->budget) {
    check_image_budget({*report, baseline, "the image", std::nullopt}, *run.spec->budget,
                       run.diagnostics);
    check_plan_budget(*plan, *run.spec->budget, run.diagnostics);
  }
  return finish(run, options);
}

Command table(SizeOptions& options) {
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
            flag("--worst", options.worst,
                 "also bound the instructions of each part, from the disassembled image"),
            text("--run", options.run_on, "also count instructions, in the target's emulator",
                 "TARGET"),
            reads(text("--baseline", options.baseline,
                       "an earlier output of --json; if a budget is exceeded, name the parts that "
                       "grew",
                       "FILE.json")),
            flag("--json", options.json_output, "print JSON")},
           diagnostics(options)}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command size_command() {
  return with_options<SizeOptions>(table);
}

}  // namespace eagerx::gen

// eagerx-gen size: what an image takes, and whether that is within the graph's budget.
#include "generator/size/size.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "generator/cli/image_budget.hpp"
#include "generator/cli/paths.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/info/info.hpp"
#include "generator/plausibility/plausibility.hpp"
#include "generator/size/tools.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Runs the image in the target's emulator, where an instruction lasts 2^shift ns.
std::optional<Instructions> count_instructions(const Run& run, const Options& options) {
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
std::optional<Json> read_baseline(Run& run, const Options& options) {
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

void print_report(const SizeReport& report, const std::optional<PlanInfo>& plan, bool as_json) {
  if (!as_json) {
    say("{}{}", size_text(report), plan ? timing_text(*plan) : "");
    return;
  }
  Json json = size_json(report);
  if (plan) {
    Json timing = info_json(*plan);
    json["ages"] = std::move(timing["ages"]);
    json["budget_ages"] = std::move(timing["budget_ages"]);
    json["link"] = std::move(timing["link"]);
  }
  say("{}\n", dump_json(json));
}

}  // namespace

int size_command(const Options& options) {
  Run run;
  run.root = data_root();
  std::optional<PlanInfo> plan;
  if (!options.graph.empty() && make(run, options)) {
    plan = info_of(*run.plan, run.spec->budget, run.diagnostics);
    allow_warnings(run.spec->allow, false, run.diagnostics);
  }
  const std::optional<Json> baseline = read_baseline(run, options);
  if (run.diagnostics.has_errors()) return finish(run, options);
  const std::string folder = fs::path(options.image).parent_path().string();
  const std::string build = !options.build.empty() ? options.build : folder.empty() ? "." : folder;
  auto report = measure_image(options.image, build, run.diagnostics);
  if (!report) return finish(run, options);
  if (!options.run_on.empty()) {
    report->instructions = count_instructions(run, options);
    if (!report->instructions)
      run.diagnostics.io_error(
          "E0911", {}, fmt::format("cannot run `{}` on `{}`", options.image, options.run_on));
  }
  if (!options.quiet) print_report(*report, plan, options.json_output);
  if (plan && run.spec->budget) {
    check_image_budget({*report, baseline, "the image", std::nullopt}, *run.spec->budget,
                       run.diagnostics);
    check_plan_budget(*plan, *run.spec->budget, run.diagnostics);
  }
  return finish(run, options);
}

}  // namespace eagerx::gen

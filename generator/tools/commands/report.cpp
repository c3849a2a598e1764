// eagerx-gen report: all information about a graph as one page for a browser.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/driver/build/built.hpp"
#include "generator/driver/build/targets.hpp"
#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/image_time.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/commands/opened_loop.hpp"
#include "generator/tools/commands/report_training.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/monitor/live.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// `output` is the page: a file; empty: <graph name>.html.
struct ReportOptions : GenerateOptions {
  std::vector<std::string> logs, images;
  std::vector<std::string> open;        // ports of loops
  std::string build;                    // the images' folder; empty: that of each
  std::optional<std::uint64_t> points;  // of a plot; without: as many as fit
  bool simulate = false;
  std::string live;      // a source; empty: a page is written
  std::string training;  // what a training left; empty: there is none
  bool no_episodes = false;
};

std::vector<PageImage> read_images(Run& run, const ReportOptions& options) {
  std::vector<PageImage> images;
  for (const std::string& image : options.images) {
    if (auto size = measure_image(image, build_folder_of(image, options.build), run.diagnostics)) {
      std::vector<std::string> nodes;
      for (const auto& [name, usage] : size->nodes) nodes.push_back(name);
      check_image_nodes(image, nodes, *run.graph, run.diagnostics);
      Diagnostics unbound;  // the page lists what has no bound
      const auto time = time_of_image(run, options, image, true, unbound);
      images.push_back(
          {image, std::move(*size), time ? std::optional(time_json(*time, false)) : std::nullopt});
    }
  }
  return images;
}

/// The module of target wasm that simulates the graph, built. Nothing if there is a problem, which
/// has been reported; `code` is the exit code.
std::optional<std::string> build_module(const ReportOptions& options, int& code) {
  GenerateOptions wasm = options;
  wasm.targets = {"wasm"};
  wasm.output.clear();
  wasm.purpose = Purpose::simulation;
  Run run;
  const auto built = build_graph(run, wasm, code);
  std::optional<std::string> module;
  if (built) {
    // Its warnings are those of the page, which tells them.
    run.diagnostics = {};
    module = load_module(built->back().image, run.diagnostics);
  }
  code = std::max(finish(run, options), code);
  return module;
}

int show_live(Run& run, const ReportOptions& options, const std::string& page) {
  const auto facts = facts_of_program(run, options);
  const int code = finish(run, options);
  if (!facts || code != kDone) return code;
  return serve_live({options.live, facts->telemetry, page},
                    {&*run.plan, options.graph, facts->hash});
}

/// Reads what a training left, and the graph with its policy, which `options` then name. False with
/// a problem.
bool make_with_training(Run& run, ReportOptions& options,
                        std::optional<ReportedTraining>& training) {
  if (options.training.empty()) return make(run, options);
  training = ReportedTraining::read(options.training, run.sources, run.diagnostics);
  if (!training) return false;
  training->choose_policy(options);
  return make(run, options) && training->check(*run.graph, run.diagnostics);
}

/// Traces that were given, and those of episodes of a training. Nothing if there is a problem,
/// which has been reported.
std::optional<Json> traces_of(Run& run, const ReportOptions& options,
                              std::optional<ReportedTraining>& training, int& code) {
  const std::size_t points = options.points.value_or(0);
  Json logs = read_logs(options.logs, *run.plan, points, run.diagnostics);
  if (!training || run.diagnostics.has_errors()) return logs;
  if (options.no_episodes) {
    training->leave_episodes_out("`--no-episodes` leaves them out");
    return logs;
  }
  const auto episodes = training->run_episodes(run, options, points, code);
  if (!episodes) return std::nullopt;
  for (const Json& log : *episodes->as<Json::List>()) logs.push_back(log);
  return logs;
}

int perform(const ReportOptions& given) {
  ReportOptions options = given;
  Run run;
  std::optional<ReportedTraining> training;
  if (!make_with_training(run, options, training)) return finish(run, options);
  std::vector<PageImage> images = read_images(run, options);
  int code = kDone;
  std::optional<Json> logs = traces_of(run, options, training, code);
  if (!logs) return code;
  if (run.diagnostics.has_errors()) return finish(run, options);
  PageContents contents;
  if (training) contents.training = training->page(*run.graph, options);
  const std::vector<const Target*> no_targets;
  check_plausibility({*run.spec, *run.graph, *run.plan, no_targets}, run.diagnostics);
  const PlanInfo info = info_of(*run.plan, run.spec->budget, run.diagnostics);
  allow_warnings(run.spec->allow, false, run.diagnostics);
  if (run.diagnostics.has_errors()) return finish(run, options);
  if (options.simulate) {
    contents.module = build_module(options, code);
    if (!contents.module) return code;
  }
  if (!options.open.empty()) {
    contents.loops = loops_json(options, options.open, code);
    if (!contents.loops) return code;
  }
  run.diagnostics.sort_by_place();
  contents.spec = &*run.spec;
  contents.policies = &run.policies;
  contents.info = &info;
  contents.sources = &run.sources;
  contents.diagnostics = &run.diagnostics;
  contents.images = std::move(images);
  contents.logs = std::move(*logs);
  contents.is_live = !options.live.empty();
  const std::uint64_t warnings = warnings_in(run.diagnostics);
  Diagnostics problems;  // those that were found are on the page
  const auto text =
      page_text((fs::path(run.root) / "templates" / "page").string(), contents, problems);
  run.diagnostics = std::move(problems);
  if (text && contents.is_live) return show_live(run, options, *text);
  const std::string path = options.output.empty() ? run.graph->name + ".html" : options.output;
  if (text && write_file(path, *text, run.diagnostics) && !options.quiet)
    say("{}: {} kB{}\n", path, (text->size() + 999) / 1000,
        warnings == 0 ? "" : ", " + counted(warnings, "warning"));
  if (text && training && !training->why_not().empty() && !options.quiet)
    complain("note: the page has no episodes: {}\n", training->why_not());
  return finish(run, options);
}

Command table(ReportOptions& options) {
  constexpr std::uint64_t kMostPoints = 9'999'999;
  return {
      .name = "report",
      .about = "show everything about a graph on one page for a browser",
      .examples =
          {{"diagram, schedule, memory and ages, in pendulum.html",
            "eagerx-gen report pendulum.yaml"},
           {"with a run as plots, and the flash and RAM of an image",
            "eagerx-gen report pendulum.yaml --trace run.log --image build/pendulum.elf -o "
            "run.html"},
           {"with stability margins of the loop through a motor: Bode, Nyquist, step response",
            "eagerx-gen report robot.yaml --open controller.u"},
           {"with the simulation in the browser, which needs Emscripten",
            "eagerx-gen report pendulum.yaml --simulate"},
           {"of a training: curves, settings, and its best and worst episode",
            "eagerx-gen report pendulum.yaml --training training.json"},
           {"live, of a program that runs with --publish foxglove:8765",
            "eagerx-gen report pendulum.yaml --live foxglove:8765"}},
      .arguments = joined(
          {{graph(options),
            writes(text("-o,--output", options.output,
                        "file of the page (default: <graph name>.html)", "FILE")),
            reads(texts("--trace", options.logs, "trace to plot; may be repeated", "LOG")),
            reads(texts("--image", options.images, "image of a board to measure; may be repeated",
                        "IMAGE.elf")),
            folder(text("--build", options.build,
                        "build folder of the image (default: the image's folder)", "DIR")),
            texts("--open", options.open,
                  "open the loop at this port, as `eagerx-gen linearize` does, and show Bode and "
                  "Nyquist plot, poles, margins and step response; may be repeated",
                  "PORT"),
            whole("--points", options.points,
                  "maximum number of points of a plot; longer plots keep the minimum and maximum "
                  "of each interval (default: at most 2000, fewer to keep all plots below 3 MB)",
                  2, kMostPoints),
            reads(text(
                "--live", options.live,
                "serve the page at a local address with the messages of a running program, from "
                "udp:[HOST:]PORT, foxglove:[HOST:]PORT, serial:DEVICE, or a growing trace",
                "SOURCE")),
            reads(text("--training", options.training,
                       "record of a training (`train --record`), or its table (--csv, or --results "
                       "of a sweep): shows curves, settings, and the last evaluation with its best "
                       "and worst episode, which the graph's program runs again",
                       "FILE")),
            flag("--no-episodes", options.no_episodes,
                 "with --training: build no program and run no episodes"),
            flag("--simulate", options.simulate,
                 "include the simulation, to reset, step and play by the policy or by hand; it is "
                 "compiled for target wasm in generated/<graph name>-wasm")},
           {variant(options), engine(options)},
           rates(options),
           {agent_policy(options), library(options)},
           diagnostics(options)}),
      .check =
          [&options] {
            return options.live.empty() || options.output.empty()
                       ? ""
                       : "--live shows the page and writes none: --output has no meaning";
          },
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command report_command() {
  return with_options<ReportOptions>(table);
}

}  // namespace eagerx::gen

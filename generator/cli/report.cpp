// eagerx-gen report: everything that is known of a graph as one page for a browser.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "generator/cli/arguments.hpp"
#include "generator/cli/built.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/paths.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/cli/targets.hpp"
#include "generator/cli/write.hpp"
#include "generator/monitor/live.hpp"
#include "generator/page/page.hpp"
#include "generator/plausibility/plausibility.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// `output` is the page: a file; empty: <graph name>.html.
struct ReportOptions : GenerateOptions {
  std::vector<std::string> logs, images;
  std::string build;                    // the images' folder; empty: that of each
  std::optional<std::uint64_t> points;  // of a plot; without: as many as fit
  bool simulate = false;
  std::string live;  // a source; empty: a page is written
};

std::vector<PageImage> read_images(Run& run, const ReportOptions& options) {
  std::vector<PageImage> images;
  for (const std::string& image : options.images) {
    if (auto size = measure_image(image, build_folder_of(image, options.build), run.diagnostics)) {
      images.push_back({image, std::move(*size)});
      check_image(images.back(), *run.graph, run.diagnostics);
    }
  }
  return images;
}

/// The module of target wasm that simulates the graph, built. Nothing if there is a problem, which
/// has been told; `code` is the exit code.
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

int perform(const ReportOptions& options) {
  Run run;
  if (!make(run, options)) return finish(run, options);
  std::vector<PageImage> images = read_images(run, options);
  Json logs = read_logs(options.logs, *run.plan, options.points.value_or(0), run.diagnostics);
  if (run.diagnostics.has_errors()) return finish(run, options);
  PageContents contents;
  const std::vector<const Target*> no_targets;
  check_plausibility({*run.spec, *run.graph, *run.plan, no_targets}, run.diagnostics);
  const PlanInfo info = info_of(*run.plan, run.spec->budget, run.diagnostics);
  allow_warnings(run.spec->allow, false, run.diagnostics);
  if (run.diagnostics.has_errors()) return finish(run, options);
  if (options.simulate) {
    int code = kDone;
    contents.module = build_module(options, code);
    if (!contents.module) return code;
  }
  run.diagnostics.sort_by_place();
  contents.spec = &*run.spec;
  contents.policies = &run.policies;
  contents.info = &info;
  contents.sources = &run.sources;
  contents.diagnostics = &run.diagnostics;
  contents.images = std::move(images);
  contents.logs = std::move(logs);
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
  return finish(run, options);
}

Command table(ReportOptions& options) {
  constexpr std::uint64_t kMostPoints = 9'999'999;
  return {
      .name = "report",
      .about = "show everything about a graph on one page for a browser",
      .examples = {{"drawing, timetable, memory and ages, in pendulum.html",
                    "eagerx-gen report pendulum.yaml"},
                   {"with a run as plots, and the flash and RAM of an image",
                    "eagerx-gen report pendulum.yaml --trace run.log --image build/pendulum.elf -o "
                    "run.html"},
                   {"with the simulation, which runs in the browser; needs Emscripten",
                    "eagerx-gen report pendulum.yaml --simulate"},
                   {"of a program that was started with --publish foxglove:8765, while it runs",
                    "eagerx-gen report pendulum.yaml --live foxglove:8765"}},
      .arguments = joined(
          {{graph(options),
            writes(text("-o,--output", options.output, "the page (default: <graph name>.html)",
                        "FILE")),
            reads(texts("--trace", options.logs, "what a run wrote with --trace, may be repeated",
                        "LOG")),
            reads(texts("--image", options.images, "an image of a board, may be repeated",
                        "IMAGE.elf")),
            folder(text("--build", options.build,
                        "build folder of the image (default: the folder that it lies in)", "DIR")),
            whole("--points", options.points,
                  "most points of a plot (default: as many as keep all plots below 3 MB, at most "
                  "2000); of more messages, the least and the greatest of each part are kept",
                  2, kMostPoints),
            reads(text("--live", options.live,
                       "show the page at an address of this machine, which is printed, with what a "
                       "running program sends: udp:[HOST:]PORT, foxglove:[HOST:]PORT, "
                       "serial:DEVICE, or a trace that grows",
                       "SOURCE")),
            flag("--simulate", options.simulate,
                 "compile the graph for target wasm, in generated/<graph name>-wasm, and put it "
                 "into "
                 "the page: reset, step, play, by the policy or by hand")},
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

// eagerx-gen report: everything that is known of a graph as one page for a browser.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/cli/built.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/cli/write.hpp"
#include "generator/page/page.hpp"
#include "generator/plausibility/plausibility.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

std::vector<PageImage> read_images(Run& run, const Options& options) {
  std::vector<PageImage> images;
  for (const std::string& image : options.images) {
    const std::string folder = fs::path(image).parent_path().string();
    const std::string build = !options.build.empty() ? options.build
                              : folder.empty()       ? "."
                                                     : folder;
    if (auto size = measure_image(image, build, run.diagnostics)) {
      images.push_back({image, std::move(*size)});
      check_image(images.back(), *run.graph, run.diagnostics);
    }
  }
  return images;
}

/// The module of target wasm that simulates the graph, built. Nothing if there is a problem, which
/// has been told; `code` is the exit code.
std::optional<std::string> build_module(const Options& options, int& code) {
  Options wasm = options;
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

}  // namespace

int report_command(const Options& options) {
  Run run;
  if (!make(run, options)) return finish(run, options);
  std::vector<PageImage> images = read_images(run, options);
  Json logs = read_logs(options.logs, *run.plan, options.points, run.diagnostics);
  if (run.diagnostics.has_errors()) return finish(run, options);
  PageContents contents;
  const std::vector<const Target*> no_targets;
  check_plausibility({*run.spec, *run.graph, *run.plan, no_targets}, run.diagnostics);
  const PlanReport report = report_of(*run.plan, run.spec->budget, run.diagnostics);
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
  contents.report = &report;
  contents.sources = &run.sources;
  contents.diagnostics = &run.diagnostics;
  contents.images = std::move(images);
  contents.logs = std::move(logs);
  const Json page = page_json(contents);
  const auto warnings =
      std::ranges::count(run.diagnostics.all(), Severity::warning, &Diagnostic::severity);
  run.diagnostics = {};  // what was found is on the page
  const auto text = page_text((fs::path(run.root) / "templates" / "report").string(), page,
                              contents.module.has_value(), run.diagnostics);
  const std::string path = options.output.empty() ? run.graph->name + ".html" : options.output;
  if (text && write_file(path, *text, run.diagnostics) && !options.quiet)
    say("{}: {} kB{}\n", path, (text->size() + 999) / 1000,
        warnings == 0 ? "" : fmt::format(", {} warning{}", warnings, warnings == 1 ? "" : "s"));
  return finish(run, options);
}

}  // namespace eagerx::gen

#include "generator/cli/pipeline.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "generator/cli/paths.hpp"
#include "generator/diagnostics/pages.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

void load_library_for(Run& run, const Options& options,
                      const std::vector<Spanned<std::string>>& more) {
  run.root = data_root();
  if (run.root.empty()) {
    run.diagnostics.io_error("E0301", {}, "cannot find the folder with models and templates").help =
        "install eagerx-gen with `cmake --install`, or set EAGERX_HOME to that folder";
    return;
  }
  std::vector<Spanned<std::string>> folders;
  for (const auto& path : options.paths) folders.push_back({path, {}});
  folders.insert(folders.end(), more.begin(), more.end());
  folders.push_back({(fs::path(run.root) / "models").string(), {}});
  folders.push_back({(fs::path(run.root) / "targets").string(), {}});
  run.library = load_library(folders, run.sources, run.diagnostics);
}

/// The spec of a graph in our own form, with the rates of the command line, and its library.
bool read_own_graph(Run& run, const YamlValue& tree, const Options& options) {
  run.spec = read_graph_spec(tree, options.graph, run.diagnostics);
  std::vector<Spanned<std::string>> folders;
  if (run.spec) {
    for (const auto& folder : run.spec->library) {
      const fs::path path = fs::path(options.graph).parent_path() / folder.value;
      // One without a name is none, and not the graph's own.
      folders.push_back({folder.value.empty() ? "" : path.string(), folder.span});
    }
    if (options.rate_hz) run.spec->rate.value = *options.rate_hz;
    if (options.engine_rate_hz && run.spec->has_engine())
      run.spec->engine.rate->value.text = options.engine_rate_hz->to_string();
  }
  const std::size_t errors_before = run.diagnostics.error_count();
  load_library_for(run, options, folders);
  return run.spec && run.diagnostics.error_count() == errors_before;
}

}  // namespace

void load(Run& run, const Options& options) {
  load_library_for(run, options, {});
}

YamlValue read_graph_file(Run& run, const std::string& path) {
  Diagnostics strict;
  YamlValue tree = read_yaml_file(path, run.sources, strict);
  if (strict.has_errors() && !strict.has_io_errors()) {
    // A file of EAGERx may have Python's tags; in a graph they are mistakes.
    const std::string& text = run.sources.text(strict.all().front().span.file);
    if (text.find("\ngui_state:") != std::string::npos)
      return read_yaml_text(path, text, run.sources, run.diagnostics, Tags::accept);
  }
  run.diagnostics = std::move(strict);
  return tree;
}

std::optional<ImportedGraph> import_file(Run& run, const YamlValue& tree, const Options& options) {
  load_library_for(run, options, {});
  if (run.diagnostics.has_errors()) return std::nullopt;
  return import_graph(tree, options.graph, run.library,
                      {options.engine, options.engine_rate_hz, options.rate_hz}, run.diagnostics);
}

namespace {

/// `--split a,b=BOARD`, which has no place in a file.
std::vector<PlacementSpec> placement_of(const Options& options) {
  std::vector<PlacementSpec> result;
  for (const auto& item : options.split) {
    const std::size_t equals = item.rfind('=');
    const std::string names = item.substr(0, equals);
    for (std::size_t begin = 0; begin <= names.size();) {
      const std::size_t end = std::min(names.find(',', begin), names.size());
      result.push_back({{names.substr(begin, end - begin), {}}, {item.substr(equals + 1), {}}});
      begin = end + 1;
    }
  }
  return result;
}

/// The trainer decides instead of the agent, whose policy may not be there yet, and on one machine.
void prepare_for_training(Run& run) {
  run.spec->agent = {};
  run.spec->placement.clear();
  if (run.spec->task) return;
  run.diagnostics
      .error("E0370", run.spec->name.span, "the graph has no `task:`, so there is nothing to learn")
      .help =
      "add one that says what is good, when an episode ends, and what success is: `task: {inputs: "
      "{th: pendulum.theta}, reward: {upright: {value: th^2, weight: -1.0}}, truncated: {after: "
      "5.0}, success: {upright: abs(th) < 0.15, over_last: 2.0}}`";
}

}  // namespace

bool make(Run& run, const Options& options) {
  const YamlValue tree = read_graph_file(run, options.graph);
  if (run.diagnostics.has_errors()) return false;
  if (is_saved_graph(tree)) {
    auto imported = import_file(run, tree, options);
    if (!imported) return false;
    run.spec = std::move(imported->spec);
  } else if (!read_own_graph(run, tree, options)) {
    return false;
  }
  if (options.training) prepare_for_training(run);
  // Before the graph is resolved, so that a bad file is told of along with everything else.
  run.policies = read_policies(*run.spec, run.library, run.diagnostics);
  run.graph = resolve(*run.spec, run.library, {options.engine, options.real, placement_of(options)},
                      run.diagnostics);
  if (!run.graph) return false;
  run.plan = make_plan(*run.graph, run.diagnostics);
  check_policies(*run.spec, *run.graph, run.policies, run.diagnostics);
  return !run.diagnostics.has_errors();
}

int finish(Run& run, const Options& options) {
  if (const auto why = flush_output()) report_output(*why, run.diagnostics);
  run.diagnostics.sort_by_place();
  if (options.quiet) run.diagnostics.drop_notes();
  if (options.json) {
    std::fputs(render_json(run.diagnostics, run.sources).c_str(), stderr);
  } else if (!run.diagnostics.all().empty()) {
    const bool terminal = isatty(STDERR_FILENO) == 1;
    std::fputs(render_text(run.diagnostics, run.sources, terminal).c_str(), stderr);
    if (terminal) std::fputs(pointer_to_pages(run.diagnostics).c_str(), stderr);
  }
  if (run.diagnostics.has_io_errors()) return kInputOutput;
  return run.diagnostics.has_errors() ? kProblems : kDone;
}

}  // namespace eagerx::gen

#include "generator/cli/pipeline.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "generator/cli/paths.hpp"
#include "generator/emit/policy_contract.hpp"

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

/// Before the graph is resolved, so that a bad file is told of along with everything else.
void read_network(Run& run) {
  const AgentSpec& agent = run.spec->agent;
  if (agent.kind != AgentSpec::Kind::policy) return;
  const auto path = fs::path(run.spec->path).parent_path() / agent.file.value;
  run.network = read_policy(path.string(), agent.file.value, agent.file.span, run.diagnostics);
}

}  // namespace

void load(Run& run, const Options& options) {
  load_library_for(run, options, {});
}

bool make(Run& run, const Options& options) {
  const Node tree = read_yaml_file(options.graph, run.sources, run.diagnostics);
  if (run.diagnostics.has_errors()) return false;
  run.spec = read_graph_spec(tree, options.graph, run.diagnostics);
  std::vector<Spanned<std::string>> folders;
  if (run.spec) {
    for (const auto& folder : run.spec->library)
      folders.push_back(
          {(fs::path(options.graph).parent_path() / folder.value).string(), folder.span});
  }
  const std::size_t errors_before = run.diagnostics.error_count();
  load_library_for(run, options, folders);
  if (!run.spec || run.diagnostics.error_count() != errors_before) return false;
  read_network(run);
  run.graph = resolve(*run.spec, run.library, {options.engine, options.real}, run.diagnostics);
  if (!run.graph) return false;
  run.plan = make_plan(*run.graph, run.diagnostics);
  if (run.network) check_policy(*run.graph, *run.network, run.diagnostics);
  return !run.diagnostics.has_errors();
}

int finish(Run& run, const Options& options) {
  run.diagnostics.sort_by_place();
  if (options.json) {
    std::fputs(render_json(run.diagnostics, run.sources).c_str(), stderr);
  } else if (!run.diagnostics.all().empty()) {
    std::fputs(render_text(run.diagnostics, run.sources, isatty(STDERR_FILENO) == 1).c_str(),
               stderr);
  }
  if (run.diagnostics.has_io_errors()) return kInputOutput;
  return run.diagnostics.has_errors() ? kProblems : kDone;
}

}  // namespace eagerx::gen

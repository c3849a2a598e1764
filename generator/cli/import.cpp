// eagerx-gen import: a file of EAGERx, rewritten as a graph.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "generator/cli/missing.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/cli/write.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// The folders of `--path` as the graph names them, so that it can be used without that option.
std::vector<Spanned<std::string>> library_of(const Options& options) {
  std::vector<Spanned<std::string>> result;
  for (const auto& path : options.paths) {
    fs::path folder = fs::absolute(path).lexically_normal();
    if (!options.output.empty())
      folder =
          folder.lexically_relative(fs::absolute(options.output).lexically_normal().parent_path());
    result.push_back({folder.string(), {}});
  }
  return result;
}

}  // namespace

int import_command(const Options& options) {
  Run run;
  const YamlValue tree = read_graph_file(run, options.graph);
  if (run.diagnostics.has_errors()) return finish(run, options);
  if (!is_saved_graph(tree)) {
    run.diagnostics
        .error("E0802", tree.span,
               "this is not a file that EAGERx's Graph.save or BaseEnv.save wrote")
        .help = "such a file has `nodes:`, `connects:` and `gui_state:`";
    return finish(run, options);
  }
  if (options.missing) return missing_command(run, tree, options);
  auto imported = import_file(run, tree, options);
  if (!imported) return finish(run, options);
  imported->spec.library = library_of(options);
  run.diagnostics.note(
      {},
      "reward and end of an episode are Python in EAGERx: write them under `task:`, "
      "which has a commented place at the end of the graph");
  const std::string text = write_graph(*imported);
  if (options.output.empty()) {
    say_text(text);
  } else if (write_file(options.output, text, run.diagnostics) && !options.quiet) {
    say("{}: {} objects, {} nodes, {} connections\n", options.output, imported->spec.objects.size(),
        imported->spec.nodes.size(), imported->spec.connections.size());
  }
  return finish(run, options);
}

}  // namespace eagerx::gen

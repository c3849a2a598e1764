// eagerx-gen import: converts a file of EAGERx into a graph.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/driver/build/targets.hpp"
#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/missing.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct ImportCommandOptions : GraphOptions {
  std::string output;    // the graph to write, or the folder for what is missing; empty: print
  bool missing = false;  // only lists what has no counterpart
};

/// The folders of `--path` as the graph names them, so that it can be used without that option.
std::vector<Spanned<std::string>> library_of(const ImportCommandOptions& options) {
  std::vector<Spanned<std::string>> result;
  for (const auto& path : options.paths) {
    fs::path folder = absolute_path(path).lexically_normal();
    if (!options.output.empty())
      folder =
          folder.lexically_relative(absolute_path(options.output).lexically_normal().parent_path());
    result.push_back({folder.string(), {}});
  }
  return result;
}

/// Reports of `check` about the written graph, which the user may complete by hand.
int check_written(const ImportCommandOptions& options, const std::string& text) {
  GraphOptions of_check;
  of_check.graph = options.output.empty() ? "<standard output>" : options.output;
  of_check.quiet = options.quiet;
  Run run;
  if (check_text(run, of_check, text)) return kDone;
  complain("`{}` was written, and `eagerx-gen check` finds {}:\n", of_check.graph,
           counted(run.diagnostics.error_count(), "error"));
  return finish(run, of_check);
}

int perform(const ImportCommandOptions& options) {
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
  if (options.missing) return list_missing(run, tree, options, options.output);
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
    say("{}: {}, {}, {}\n", options.output, counted(imported->spec.objects.size(), "object"),
        counted(imported->spec.nodes.size(), "node"),
        counted(imported->spec.connections.size(), "connection"));
  }
  const bool written = !run.diagnostics.has_errors();
  const int code = finish(run, options);
  return written ? std::max(code, check_written(options, text)) : code;
}

Command table(ImportCommandOptions& options) {
  return {.name = "import",
          .about = "convert a file that EAGERx saved (Graph.save, BaseEnv.save) to a graph",
          .examples =
              {{"convert it, and choose the engine",
                "eagerx-gen import state.yaml -o graph.yaml --engine OdeEngine --engine-rate 60"},
               {"make a folder with a skeleton for each class that has no C++ counterpart",
                "eagerx-gen import state.yaml --missing -o models"}},
          .arguments = joined(
              {{required(reads(
                    text("state", options.graph, "the file that EAGERx saved", "STATE.yaml"))),
                writes(text("-o,--output", options.output,
                            "file of the graph (default: print it); with --missing, the folder",
                            "FILE")),
                flag("--missing", options.missing,
                     "list the classes without a C++ counterpart; with -o, make a folder for each"),
                flag("--keep-processes", options.keep_processes,
                     "make each node with NEW_PROCESS a part (default: one program)"),
                text("--engine", options.engine, "engine to use if the file names none", "NAME")},
               rates(options),
               {library(options)},
               diagnostics(options)}),
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command import_command() {
  return with_options<ImportCommandOptions>(table);
}

}  // namespace eagerx::gen

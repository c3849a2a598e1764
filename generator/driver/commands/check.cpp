// eagerx-gen check: reports all problems of a graph and of the code of its entities.
#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "generator/backend/compile/compile.hpp"
#include "generator/driver/build/built.hpp"
#include "generator/driver/build/emitted.hpp"
#include "generator/driver/build/targets.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/check_targets.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/manifest_check.hpp"
#include "generator/driver/commands/train_file.hpp"
#include "generator/driver/pipeline/check_variants.hpp"
#include "generator/graph/resolve/needs.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

void compile_entities(Run& run, const std::vector<const Target*>& targets,
                      Diagnostics& diagnostics) {
  const TemporaryFolder folder;
  if (folder.path().empty()) {
    diagnostics.io_error("E0901", {},
                         fmt::format("cannot make a temporary folder: {}", std::strerror(errno)));
    return;
  }
  const auto files = emit_whole(run, emit_options_for(run, targets, folder.path()));
  if (!files) return;
  const char* compiler = std::getenv("CXX");
  check_entities(*run.plan, *files, folder,
                 {compiler != nullptr && *compiler != '\0' ? compiler : "c++", run.root,
                  run.graph->include_roots, packages_of(*run.graph, Part::whole)},
                 run.sources, diagnostics);
}

namespace {

struct CheckOptions : GraphOptions {
  bool compile = false;  // also the code of entities
};

/// Of a manifest, or settings of a training; nullopt if the file is a graph.
std::optional<int> perform_other(const CheckOptions& options) {
  Run run;
  const auto file = load_yaml_file(options.graph, run.sources, run.diagnostics);
  const std::string text = file ? run.sources.text(*file) : std::string();
  if (is_manifest(options.graph)) {
    if (file) check_manifest(run, options, options.graph, text);
  } else if (is_train_file(text)) {
    check_train_file(run, options.graph, text);
  } else {
    return std::nullopt;
  }
  const int code = finish(run, options);
  if (code == kDone && !options.quiet) say("{}: no problems\n", options.graph);
  return code;
}

int perform(const CheckOptions& options) {
  if (const auto code = perform_other(options)) return *code;
  Run run;
  const std::string output = options.compile ? "/" : "";  // the compiler gets whole paths
  const auto targets = make(run, options) ? check_targets(run, options, output) : std::nullopt;
  if (targets && options.compile) compile_entities(run, *targets, run.diagnostics);
  const std::size_t variants =
      targets && options.variant.empty() ? check_variants(run, options) : 0;
  const int code = finish(run, options);
  if (code == kDone && !options.quiet) {
    std::uint64_t messages = 0;
    const std::uint64_t warnings = warnings_in(run.diagnostics);
    for (const auto& ring : run.plan->rings) messages += ring.capacity;
    say("{}: {}, {}, {} with room for {}; {}{}\n", options.graph,
        counted(run.graph->nodes.size(), "node"), counted(run.plan->rates.size(), "rate"),
        counted(run.plan->rings.size(), "buffer"), counted(messages, "message"),
        warnings == 0 ? "no problems" : counted(warnings, "warning"),
        variants == 0 ? std::string()
                      : fmt::format("; {} of the right form", counted(variants, "variant")));
  }
  return code;
}

Command table(CheckOptions& options) {
  return {
      .name = "check",
      .about = "check a graph, a manifest or settings, and write nothing",
      .examples = {{"check a graph", "eagerx-gen check pendulum.yaml"},
                   {"a manifest, without a graph that uses it",
                    "eagerx-gen check my_models/gain/manifest.yaml"},
                   {"the settings of a training, or a sweep", "eagerx-gen check settings.yaml"},
                   {"also the code of the entities", "eagerx-gen check pendulum.yaml --compile"},
                   {"with your own entities, messages as JSON",
                    "eagerx-gen check pendulum.yaml --path my_models --diagnostics json"}},
      .arguments = joined(
          {{graph(options)},
           selection(options),
           rates(options),
           {library(options), warnings(options)},
           {cut_out_nodes(options, "check only the library of these nodes, as for generate --of"),
            flag("--compile", options.compile,
                 "also compile the entities under the rules of boards: no heap, no <cmath>, no "
                 "double in a graph of floats")},
           diagnostics(options)}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command check_command() {
  return with_options<CheckOptions>(table);
}

}  // namespace eagerx::gen

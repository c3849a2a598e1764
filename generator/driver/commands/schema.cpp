// eagerx-gen schema: JSON schemas for completion and checks in editors.
#include "generator/frontend/library/schema.hpp"

#include <utility>

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/train_settings.hpp"
#include "generator/driver/commands/train_sweep.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/frontend/spec/schema.hpp"

namespace eagerx::gen {
namespace {

struct SchemaOptions : LibraryOptions {
  bool of_library = false, of_manifests = false, of_settings = false, of_sweeps = false;
};

int perform(const SchemaOptions& options) {
  if (options.of_settings) {
    say("{}", train_settings_schema());
    return kDone;
  }
  if (options.of_sweeps) {
    say("{}", train_sweep_schema());
    return kDone;
  }
  if (options.of_manifests) {
    say("{}",
        schema_text(manifest_schema(), "eagerx-gen manifest", "eagerx-gen/manifest.schema.json"));
    return kDone;
  }
  if (!options.of_library && options.paths.empty()) {
    say("{}", json_schema(graph_format(), "eagerx-gen graph", "eagerx-gen/graph.schema.json"));
    return kDone;
  }
  Run run;
  load(run, options);
  if (!run.diagnostics.has_errors())
    say("{}", schema_text(graph_schema(run.library), "eagerx-gen graph of a library",
                          "eagerx-gen/library.schema.json"));
  return finish(run, options);
}

Command table(SchemaOptions& options) {
  Argument manifest = flag("--manifest", options.of_manifests, "for manifests");
  return {
      .name = "schema",
      .about = "print a JSON schema for editors",
      .examples = {{"for graphs, with the entities of eagerx-gen and your own",
                    "eagerx-gen schema --graph --path my_models >graph.schema.json"},
                   {"for manifests", "eagerx-gen schema --manifest >manifest.schema.json"},
                   {"for settings of a training",
                    "eagerx-gen schema --train-settings >settings.schema.json"},
                   {"for graphs, with any entities", "eagerx-gen schema >graph.schema.json"}},
      .arguments = {flag("--graph", options.of_library,
                         "for graphs, with the ids, ports and parameters of all entities found"),
                    std::move(manifest),
                    flag("--train-settings", options.of_settings,
                         "for files of `train --settings`"),
                    flag("--train-sweep", options.of_sweeps, "for files of `train --sweep`"),
                    library(options)},
      .check =
          [&options] {
            const bool of_graphs = options.of_library || !options.paths.empty();
            const int kinds = (of_graphs ? 1 : 0) + (options.of_manifests ? 1 : 0) +
                              (options.of_settings ? 1 : 0) + (options.of_sweeps ? 1 : 0);
            return kinds > 1 ? "a schema is of graphs (--graph, --path), --manifest, "
                               "--train-settings or --train-sweep: ask for one"
                             : "";
          },
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command schema_command() {
  return with_options<SchemaOptions>(table);
}

}  // namespace eagerx::gen

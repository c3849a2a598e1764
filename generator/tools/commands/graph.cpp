// eagerx-gen graph: a picture of a graph.
#include <fmt/format.h>

#include <utility>

#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/drawing/format.hpp"

namespace eagerx::gen {
namespace {

struct GraphPictureOptions : GraphOptions {
  std::string output;         // a file; empty: <graph name>.svg
  bool engine_graph = false;  // with what runs on the engine
};

int perform(const GraphPictureOptions& options) {
  Run run;
  if (!make(run, options)) return finish(run, options);
  const Drawing drawing = drawing_of(*run.graph, run.spec->composites,
                                     options.engine_graph ? GraphView::engine : GraphView::user);
  const std::string path = options.output.empty() ? run.graph->name + ".svg" : options.output;
  const std::string text = drawing_text(drawing, *drawing_format_of(path));
  if (write_file(path, text, run.diagnostics) && !options.quiet)
    say("{}: {}, {}\n", path, counted(drawing.boxes.size(), "box", "boxes"),
        counted(drawing.wires.size(), "connection"));
  return finish(run, options);
}

Command table(GraphPictureOptions& options) {
  Argument output = checked(
      writes(text("-o,--output", options.output,
                  "file of the picture, .svg, .dot (Graphviz) or .mmd (Mermaid) (default: <graph "
                  "name>.svg)",
                  "FILE")),
      [](const std::string& path) { return drawing_format_of(path).has_value(); },
      "ends in none of .svg, .dot, .mmd");
  return {
      .name = "graph",
      .about = "draw a graph as a picture",
      .examples = {{"pendulum.svg, for a browser or a README", "eagerx-gen graph pendulum.yaml"},
                   {"with the nodes that run on the engine, for Graphviz",
                    "eagerx-gen graph pendulum.yaml --engine-graph -o pendulum.dot"}},
      .arguments = joined({{graph(options), std::move(output),
                            flag("--engine-graph", options.engine_graph,
                                 "draw the engine nodes of each object instead of one box")},
                           {variant(options), engine(options)},
                           rates(options),
                           {library(options)},
                           diagnostics(options)}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command graph_command() {
  return with_options<GraphPictureOptions>(table);
}

}  // namespace eagerx::gen

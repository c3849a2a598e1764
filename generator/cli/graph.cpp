// eagerx-gen graph: a picture of a graph.
#include <fmt/format.h>

#include "generator/cli/pipeline.hpp"
#include "generator/cli/write.hpp"
#include "generator/drawing/format.hpp"

namespace eagerx::gen {

int graph_command(const Options& options) {
  Run run;
  if (!make(run, options)) return finish(run, options);
  const Drawing drawing = drawing_of(*run.graph, run.spec->composites,
                                     options.engine_graph ? GraphView::engine : GraphView::user);
  const std::string path = options.output.empty() ? run.graph->name + ".svg" : options.output;
  const std::string text = drawing_text(drawing, *drawing_format_of(path));
  if (write_file(path, text, run.diagnostics) && !options.quiet)
    say("{}: {} boxes, {} connections\n", path, drawing.boxes.size(), drawing.wires.size());
  return finish(run, options);
}

}  // namespace eagerx::gen

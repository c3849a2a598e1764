// Graphs made of graphs: expands arrays and composites of a graph file into entities and
// connections. The result is a flat graph file; its spans say where everything is written and used.
#pragma once

#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {

struct FlatGraph {
  YamlValue root;
  GraphForm form = GraphForm::written;    // flat: something was composed
  PortBindings ends = {};                 // ports of its composites
  std::vector<CompositeSpec> composites;  // where they are, for pictures
};

/// The flat graph. Inner names are `arm/position`, those of arrays `leg[0]`. Problems: E0390 a
/// composite that cannot be bound, E0391 counts that do not fit, E0392 an index out of range, E0393
/// a cycle of composites or too many of them, E0396 a parameter that is not tunable, and those of
/// parameters.
FlatGraph compose(const YamlValue& root, const Library& library, SourceMap& sources,
                  Diagnostics& diagnostics);

}  // namespace eagerx::gen

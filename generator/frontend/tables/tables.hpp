// Parameters whose numbers are in a file: `{csv: FILE, column: NAME}` instead of a list.
#pragma once

#include <string>
#include <vector>

#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Replaces every `{csv: …}` under a `config:` of the graph with its numbers, so that later stages
/// do not know their source; each number has its place in the file. Without `column`, all numbers
/// are used, row by row. Paths are relative to the graph's folder. Returns the files read. Codes:
/// E0345 a file that cannot be read or is too large, E0346 an error in it, E0347 a missing column.
std::vector<std::string> read_tables(GraphSpec& spec, SourceMap& sources, Diagnostics& diagnostics);

}  // namespace eagerx::gen

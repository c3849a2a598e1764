// Parameters whose numbers are in a file: `{csv: FILE, column: NAME}` instead of a list.
#pragma once

#include <string>
#include <vector>

#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Replaces every `{csv: …}` under a `config:` of the graph by its numbers, so that no later
/// stage knows where they came from; each number has its place in the file. Without `column` it is
/// all numbers, row after row. Paths begin at the folder of the graph. The files that were read.
/// Codes: E0345 a file that cannot be read or is too large, E0346 what is wrong in it, E0347 a
/// missing column.
std::vector<std::string> read_tables(GraphSpec& spec, SourceMap& sources, Diagnostics& diagnostics);

}  // namespace eagerx::gen

// A graph tree as the text of a graph file, with the source of every line.
#pragma once

#include <string>

#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// YAML that reads as the same tree. A comment after every line that is not from `root`'s own file
/// names its file and line.
std::string flat_text(const YamlValue& root, const SourceMap& sources);

}  // namespace eagerx::gen

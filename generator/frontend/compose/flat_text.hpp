// A graph tree as the text of a graph file, with the source of every line.
#pragma once

#include <string>

#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// YAML that reads as the same tree. Behind every line that is not from `root`'s own file stands
/// the file and line that it is from.
std::string flat_text(const YamlValue& root, const SourceMap& sources);

}  // namespace eagerx::gen

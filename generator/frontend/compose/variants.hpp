// One robot, several graphs: overlays `extends: FILE` and `variants:` key by key.
#pragma once

#include <string>

#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The graph of `variant` (empty: the file's own), without the keys `extends` and `variants`.
/// Problems: E0394 an unknown variant, a cycle of files; E0395 an entry to remove that is missing
/// or still used; those of reading.
YamlValue choose_variant(YamlValue root, const std::string& path, const std::string& variant,
                         SourceMap& sources, Diagnostics& diagnostics);

/// The names of the variants of a file and of those it extends.
std::vector<std::string> variants_of(const YamlValue& root, const std::string& path,
                                     SourceMap& sources, Diagnostics& diagnostics);

}  // namespace eagerx::gen

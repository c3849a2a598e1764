// Overlays one graph on another: its values take precedence, and it can remove entries.
#pragma once

#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// A key that no file has: what was removed, and where that is said.
inline constexpr const char* kRemovedEntities = "remove[d]";

/// `base` with what `over` says. Mappings are laid over each other key by key, but one with another
/// `type` takes the place of the one below; the target port identifies a connection
/// ; everything else is replaced. Before, what `remove:` names goes (E0395 if it is not there).
YamlValue laid_over(YamlValue base, YamlValue over, Diagnostics& diagnostics);

/// Whether a connection has an end at something that was removed: E0395.
void check_removed(const YamlValue& graph, Diagnostics& diagnostics);

}  // namespace eagerx::gen

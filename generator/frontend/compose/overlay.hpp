// Overlays one graph on another: its values take precedence, and it can remove entries.
#pragma once

#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// A key that files cannot contain: removed entries, and the places of their removal.
inline constexpr const char* kRemovedEntities = "remove[d]";

/// Overlays `over` on `base`. Mappings merge key by key, but one with another `type` replaces the
/// one below; the target port identifies a connection; everything else is replaced. Entries under
/// `remove:` are removed first (E0395 if one is missing).
YamlValue laid_over(YamlValue base, YamlValue over, Diagnostics& diagnostics);

/// Whether a connection has an end at something that was removed: E0395.
void check_removed(const YamlValue& graph, Diagnostics& diagnostics);

}  // namespace eagerx::gen

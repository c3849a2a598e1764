// Ports of nodes and objects, from their manifests and their settings in the graph.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// A manifest's settings of the connections to a port, with references replaced (E0204 where one is
/// no number of messages or seconds).
ConnectionSettings manifest_settings(const PortManifest& port, const References& references,
                                     Diagnostics& diagnostics);
/// An input or output as its manifest describes it.
UnresolvedOutput draft_output(const PortManifest& port, Span span, const References& references,
                              Diagnostics& diagnostics);
UnresolvedInput draft_input(const PortManifest& port, const std::string& written, Span span,
                            const References& references, Diagnostics& diagnostics);
/// Applies a graph's settings to an output of a manifest: a processor, and the space of the
/// published message.
void apply_overrides(UnresolvedOutput& output, const ComponentSpec& said,
                     const std::string& written, Diagnostics& diagnostics);
/// The settings of a port, or nullptr.
const ComponentSpec* find_component(const Selection& selection, std::string_view name);
/// Reports names in the selection that are not among the entity's `ports` (E0307); true if there
/// are any. `what`: their kind, "sensor", "input", …
bool report_unknown(const Selection& selection, const std::vector<PortManifest>& ports,
                    const Entity& entity, std::string_view what, Diagnostics& diagnostics);
/// E0308: an engine node or state that is of other engines.
void report_wrong_engine(const Entity& entity, const Entity& engine, Span span,
                         Diagnostics& diagnostics);

}  // namespace eagerx::gen

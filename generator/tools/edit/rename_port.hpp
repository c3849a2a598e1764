// Ports of entities, wherever graphs, manifests and headers name them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/tools/edit/edit.hpp"

namespace eagerx::gen {

/// A port as a text names it.
struct PortUse {
  std::string owner;  // the object or node of a graph; empty in a manifest
  std::string type;   // the id of its entity; empty if it has none
  std::string port;
  Bytes place;  // of the port's name
};
/// The port that the word at byte `at` names in a graph: after its owner (`pendulum.theta`), or in
/// the owner's list of ports.
std::optional<PortUse> port_in_graph(std::string_view text, std::size_t at);
/// The port that is declared at byte `at` of a manifest.
std::optional<PortUse> port_in_manifest(std::string_view text, std::size_t at);

/// All places of a graph that name the port `port` of an entity, for all objects and nodes of that
/// entity.
std::vector<Bytes> uses_of_port(std::string_view graph, const std::string& id,
                                const std::string& port);
/// All places of a manifest: that of the entity itself, of its implementations, and of entities
/// that contain it.
std::vector<Bytes> uses_of_port_in_manifest(std::string_view manifest, const std::string& id,
                                            const std::string& port);
/// In the header of a node's class: `in.port`, `out.port`, `Io::Inputs::port` and the like.
std::vector<Bytes> uses_of_port_in_header(std::string_view header, const std::string& port);

/// Why a port of this manifest cannot get that name; empty: it can. One whose name the manifest
/// also has for something else is not renamed: it would be ambiguous.
std::string why_no_port(std::string_view manifest, const std::string& from, const std::string& to);

}  // namespace eagerx::gen

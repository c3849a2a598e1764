// Ports of a possibly incomplete graph that connections can name.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "generator/frontend/outline/outline.hpp"
#include "generator/tools/lsp/schema_view.hpp"

namespace eagerx::gen::lsp {

/// The library's facts for files that use it.
struct LibraryFacts {
  Json schema;  // of the file
  /// Of entities that are reset nodes, by their ids: the names of their targets.
  std::map<std::string, std::vector<std::string>, std::less<>> reset_targets = {};
};

enum class PortSide : unsigned char { sends, receives };

struct NamedPort {
  std::string name;  // as a connection writes it: "pendulum.theta", "actions.voltage"
  std::string about;
  PortSide side = PortSide::sends;
  bool is_chosen = false;  // the graph names it where it is, or all ports
};

/// Ports of the objects and nodes that have a type, of the agent, and of nodes with a policy whose
/// ports are written in the graph. One that the graph has not chosen can be meant, too. Where there
/// is a reset node also its targets and feedthroughs, and the states of objects.
std::vector<NamedPort> ports_of(const LibraryFacts& library, const OutlineNode& graph);

/// The ports of one side that the connections of the graph name already.
std::vector<std::string> connected(const OutlineNode& graph, PortSide side);

}  // namespace eagerx::gen::lsp

// The environment, the engine and the nodes, with their ports.
#pragma once

#include <set>
#include <string_view>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void add_environment(UnresolvedGraph& draft);
void add_engine(UnresolvedGraph& draft, const ResolveOptions& options);
void add_nodes(UnresolvedGraph& draft);
/// A node, whose optional inputs exist if `connected` has their names.
UnresolvedNode node_of(UnresolvedGraph& draft, const EntitySpec& spec,
                       const std::set<std::string_view>& connected);

}  // namespace eagerx::gen

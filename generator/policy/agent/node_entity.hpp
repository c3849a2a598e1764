// A node that runs a policy, as an entity of the library: it has no manifest.
#pragma once

#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// The entity of `node`: its inputs and outputs are those of the graph, with the weights' size
/// and bounds; the class is generated. `network` is nullptr if the weights could not be read.
Entity policy_entity(const GraphSpec& spec, const EntitySpec& node, const Network* network);

}  // namespace eagerx::gen

// A node that runs a policy, as an entity of the library: the graph has no manifest for it.
#pragma once

#include "generator/library/library.hpp"
#include "generator/network/network.hpp"
#include "generator/spec/graph_spec.hpp"

namespace eagerx::gen {

/// What `node` is: its inputs and outputs are what the graph says, and what the weights say of size
/// and bounds; the class is generated. `network` is nullptr if the weights could not be read.
Entity policy_entity(const GraphSpec& spec, const EntitySpec& node, const Network* network);

}  // namespace eagerx::gen

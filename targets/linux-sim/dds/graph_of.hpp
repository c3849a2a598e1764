// Description of a graph's program for DDS.
#pragma once

#include <runtime/host/dds/topics.hpp>
#include <targets/linux-sim/graph_program.hpp>

namespace eagerx::linux_sim {

dds::Graph graph_of(const GraphFacts& facts);

}  // namespace eagerx::linux_sim

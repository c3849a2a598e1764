#include <charconv>
#include <targets/linux-sim/dds/graph_of.hpp>

namespace eagerx::linux_sim {
namespace {

std::vector<std::uint32_t> shape_of(const GraphFacts& facts, std::size_t channel) {
  std::vector<std::uint32_t> shape;
  for (std::size_t i = 0; i < facts.shape_count; ++i) {
    if (facts.shapes[i].channel != channel) continue;
    const std::string_view text = facts.shapes[i].sizes;  // "4x3"
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::uint32_t size = 0; at < end; ++at) {
      at = std::from_chars(at, end, size).ptr;
      shape.push_back(size);
    }
  }
  return shape;
}

}  // namespace

dds::Graph graph_of(const GraphFacts& facts) {
  dds::Graph graph{facts.name, {}};
  for (std::size_t c = 0; c < facts.channel_count; ++c) {
    const Channel& channel = facts.channels[c];
    graph.ports.push_back({channel.name, channel.port, *trace_log::dtype_of(channel.dtype),
                           shape_of(facts, c), channel.publisher == Publisher::engine_node});
  }
  return graph;
}

}  // namespace eagerx::linux_sim

// Messages on the links between the programs of a placed graph.
#pragma once

#include <optional>
#include <vector>

#include "generator/graph/plan/plan.hpp"
#include "generator/graph/resolve/needs.hpp"

namespace eagerx::gen {

/// Needs everything of the plan but the split, and the graph's placement.
Split make_split(const Plan& plan);

/// A program's use of a message at its links, each named after its part. A part has only its own
/// link; the hub has all links, and forwards messages between parts.
struct LinkUse {
  std::optional<std::size_t> from;
  std::vector<std::size_t> to;
  [[nodiscard]] bool any() const { return from || !to.empty(); }
};
LinkUse link_use(const Plan& plan, Part part, std::size_t node, std::size_t output);
/// The same for the flags of the reset node `node`, whether it has reached its targets, which all
/// programs receive.
LinkUse link_use_of_flags(const Graph& graph, Part part, std::size_t node);

/// Whether the program `part` is the hub and requests the messages of `node` without waiting.
bool is_pipelined(const Plan& plan, Part part, std::size_t node);

}  // namespace eagerx::gen

// Bounds of an applied action: its own space, and those of the actuators that receive it unchanged.
#include <fmt/format.h>

#include <algorithm>

#include "generator/graph/resolve/bounds.hpp"
#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {
namespace {

/// `space` without what `other` does not take; where they have nothing in common, the other's.
Space common(Space space, const Space& other) {
  std::vector<double> low, high;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const double other_low = bound_of(other.low, i, lowest_of(other.dtype));
    const double other_high = bound_of(other.high, i, highest_of(other.dtype));
    low.push_back(std::max(bound_of(space.low, i, lowest_of(space.dtype)), other_low));
    high.push_back(std::min(bound_of(space.high, i, highest_of(space.dtype)), other_high));
    if (low.back() <= high.back()) continue;
    low.back() = other_low;
    high.back() = other_high;
  }
  space.low = std::move(low);
  space.high = std::move(high);
  return space;
}

bool is_within(const Space& space, const Space& other) {
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (bound_of(space.low, i, lowest_of(space.dtype)) <
            bound_of(other.low, i, lowest_of(other.dtype)) ||
        bound_of(space.high, i, highest_of(space.dtype)) >
            bound_of(other.high, i, highest_of(other.dtype)))
      return false;
  }
  return true;
}

}  // namespace

void find_applied_spaces(Graph& graph) {
  for (const auto& action : graph.environment().outputs)
    graph.applied.push_back({action.space, {}, action.span});
  for (const auto& node : graph.nodes) {
    for (const auto& input : node.inputs) {
      if (!input.actuator || input.processor || input.source_node != Graph::kEnvironment) continue;
      AppliedAction& applied = graph.applied[input.source_output];
      if (is_within(applied.space, input.space)) continue;
      applied.space = common(std::move(applied.space), input.space);
      applied.narrowed_by += (applied.narrowed_by.empty() ? "" : ", ") + input.written;
      applied.span = input.span;
    }
  }
}

}  // namespace eagerx::gen

// Rates on an integer grid, and the slots of the hyperperiod.
#pragma once

#include <optional>
#include <vector>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// The distinct rates of the graph, fastest first, with their periods on a common grid; nullopt and
/// E0402 if there is no such grid in 63 bits, E0403 if there are more rates than bits in a mask.
std::optional<std::vector<RateClass>> find_rates(const Graph& graph, Diagnostics& diagnostics);

/// The slots and the cheapest form for them. `environment`: index of its rate; `nodes`: how many
/// there are; `any_slot`: whether a routine may end at any slot of a step, as those of reset nodes.
Schedule make_schedule(const std::vector<RateClass>& rates, std::size_t environment,
                       std::size_t nodes, bool any_slot = false);

}  // namespace eagerx::gen

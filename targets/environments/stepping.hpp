// How the environments of a batch are stepped, and what made it slower than it could be.
#pragma once

#include <cstdint>
#include <string>
#include <targets/environments/pack_kernel.hpp>
#include <targets/environments/packs_of_processor.hpp>

namespace eagerx::environments {

template <class Graph>
std::string name_of_packs(const PackKernel<Graph>& kernel) {
  return "packs of " + std::to_string(kernel.lanes) + " (" + kernel.isa + ")";
}

/// `used`: the packs of `environments` of them, `widest`: those of many. `graph_has_none`: why the
/// graph has no packs; empty if it has.
template <class Graph>
std::string stepping_text(const PackKernel<Graph>& used, const PackKernel<Graph>& widest,
                          std::uint32_t environments, bool draws,
                          const std::string& graph_has_none) {
  const std::string one_by_one = "one by one: ";
  if (!graph_has_none.empty()) return one_by_one + graph_has_none;
  if (draws) return one_by_one + "their pictures are wanted";
  if (widest.lanes == 0) return one_by_one + "EAGERX_PACKS or this processor allows no packs";
  const std::string few = std::to_string(environments) +
                          (environments == 1 ? " environment is" : " environments are") +
                          " too few for ";
  if (used.lanes == 0) return one_by_one + few + "packs";
  const std::string packs = "in " + name_of_packs(used);
  return used.lanes == widest.lanes ? packs : packs + "; " + few + name_of_packs(widest);
}

}  // namespace eagerx::environments

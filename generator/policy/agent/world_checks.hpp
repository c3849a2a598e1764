// Compares the graph's actions and observations with those of a policy's training. Inside
// generator/policy/agent only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "generator/policy/agent/world.hpp"

namespace eagerx::gen {

/// Whether two numbers are the same; the file may hold them in float32.
inline bool same_number(double a, double b) {
  constexpr double kFloat32 = 1e-6;
  return a == b || std::fabs(a - b) <= kFloat32 * std::max(std::fabs(a), std::fabs(b));
}

/// Value `i` of bounds that are one for all, one for each, or not there.
inline std::optional<double> bound_of(const std::vector<double>& bounds, std::size_t i,
                                      std::size_t count) {
  if (bounds.size() == 1) return bounds.front();
  return bounds.size() == count ? std::optional<double>(bounds[i]) : std::nullopt;
}

/// The conversion of the policy's outputs, and the bounds or choices of the actions: E0704, E0705.
void check_policy_actions(const PolicyUse& use, const Network& network, Diagnostics& diagnostics);

/// The order of the observations, by their names or bounds, and the shape of an image: E0706,
/// E0708.
void check_policy_observations(const PolicyUse& use, const Network& network,
                               Diagnostics& diagnostics);

}  // namespace eagerx::gen

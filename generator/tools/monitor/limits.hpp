// Distance of a message from its limits.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace eagerx::gen {

struct NearestLimit {
  std::size_t element = 0;
  bool is_high = false;
  double bound = 0.0;
  /// Of the range between both limits, or where there is one limit, of that. Negative: beyond.
  double left = 0.0;
};

/// Of the element that is nearest to one of its limits. Nothing if it has none.
std::optional<NearestLimit> nearest_limit(const std::vector<double>& values,
                                          const std::vector<double>& low,
                                          const std::vector<double>& high);

/// Whether all elements are those of the safe action, as float32.
bool is_safe_action(const std::vector<double>& values, const std::vector<double>& safe);

}  // namespace eagerx::gen

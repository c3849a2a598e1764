#include "generator/tools/monitor/limits.hpp"

#include <algorithm>
#include <cmath>

namespace eagerx::gen {

std::optional<NearestLimit> nearest_limit(const std::vector<double>& values,
                                          const std::vector<double>& low,
                                          const std::vector<double>& high) {
  std::optional<NearestLimit> nearest;
  const auto look = [&](std::size_t element, bool is_high, double bound, double distance,
                        double range) {
    if (!std::isfinite(bound) || !std::isfinite(values[element])) return;
    const double of = std::isfinite(range) && range > 0.0 ? range : std::max(std::abs(bound), 1.0);
    const NearestLimit here{element, is_high, bound, distance / of};
    if (!nearest || here.left < nearest->left) nearest = here;
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool has_low = i < low.size(), has_high = i < high.size();
    const double range = has_low && has_high ? high[i] - low[i] : HUGE_VAL;
    if (has_low) look(i, false, low[i], values[i] - low[i], range);
    if (has_high) look(i, true, high[i], high[i] - values[i], range);
  }
  return nearest;
}

bool is_safe_action(const std::vector<double>& values, const std::vector<double>& safe) {
  return !safe.empty() && std::ranges::equal(values, safe, [](double a, double b) {
    return static_cast<float>(a) == static_cast<float>(b);
  });
}

}  // namespace eagerx::gen

#include "generator/tools/linear/corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

std::vector<std::size_t> sampled_parameters(const Hyperperiod& there) {
  std::vector<std::size_t> sampled;
  for (std::size_t k = 0; k < there.states.size(); ++k) {
    const ResetElement& each = there.states[k];
    if (!each.sample_low || !each.sample_high || *each.sample_low >= *each.sample_high) continue;
    if (is_parameter(there, each)) sampled.push_back(k);
  }
  return sampled;
}

std::optional<std::vector<Corner>> corners_of(const Hyperperiod& there) {
  constexpr std::size_t kMost = 8;
  const std::vector<std::size_t> sampled = sampled_parameters(there);
  if (sampled.size() > kMost) return std::nullopt;
  std::vector<Corner> corners;
  for (std::size_t bits = 0; bits < std::size_t{1} << sampled.size(); ++bits) {
    std::vector<double> values;
    for (const ResetElement& each : there.states) values.push_back(each.value);
    std::vector<bool> is_set(values.size());
    for (std::size_t i = 0; i < sampled.size(); ++i) {
      const ResetElement& each = there.states[sampled[i]];
      values[sampled[i]] = ((bits >> i) & 1U) != 0 ? *each.sample_high : *each.sample_low;
      is_set[sampled[i]] = true;
    }
    Corner corner;
    for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end) {
      std::string text = there.states[begin].state + "=";
      bool any = false;
      for (; end < values.size() && there.states[end].state == there.states[begin].state; ++end) {
        text += fmt::format("{}{:.7g}", end == begin ? "" : ",", values[end]);
        any = any || is_set[end];
      }
      if (any) corner.push_back(text);
    }
    corners.push_back(std::move(corner));
  }
  return corners;
}

void WorstMargins::take(const Margins& found, const Corner& corner) {
  const std::string at = join(corner, " ");
  const bool is_first = corners++ == 0;
  const auto worse = [&](auto& figure, const auto& other, std::string& where, auto is_worse) {
    if (!other || (figure && !is_worse(*other, *figure))) return false;
    figure = other;
    where = at;
    return true;
  };
  if (is_first || found.spectral_radius > margins.spectral_radius) {
    margins.spectral_radius = found.spectral_radius;
    stability_at = at;
  }
  margins.is_stable = (is_first || margins.is_stable) && found.is_stable;
  margins.port_period_s = found.port_period_s;
  worse(margins.phase_deg, found.phase_deg, phase_at,
        [](double a, double b) { return std::abs(a) < std::abs(b); });
  worse(margins.gain, found.gain, gain_at, std::less<>());
  worse(margins.least_gain, found.least_gain, least_gain_at, std::greater<>());
  worse(margins.delay_s, found.delay_s, delay_at, std::less<>());
}

}  // namespace eagerx::gen

#include "generator/tools/monitor/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eagerx::gen {

std::string exact_text(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{}", value);
}

std::string short_text(double value, std::size_t columns) {
  for (int digits = 6; digits > 1; --digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    if (text.size() <= columns) return text;
  }
  return fmt::format("{:.0e}", value);
}

std::string duration_text(double seconds) {
  constexpr double kMinute = 60.0, kHour = 3600.0, kMs = 1e-3;
  const double size = std::abs(seconds);
  if (size < kMs) return fmt::format("{:.0f} us", seconds * 1e6);
  if (size < 1.0) return fmt::format("{:.{}f} ms", seconds / kMs, size < 0.01 ? 1 : 0);
  if (size < kMinute) return fmt::format("{:.{}f} s", seconds, size < 10.0 ? 1 : 0);
  if (size < 100.0 * kMinute) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.0f} h", seconds / kHour);
}

std::string rate_text(double hz) {
  const double rounded = std::round(hz);
  if (std::abs(hz - rounded) < 0.005 * std::max(hz, 1.0) && rounded > 0.0)
    return fmt::format("{:.0f}", std::min(rounded, 9e9));
  return fmt::format("{:.3g}", hz);
}

}  // namespace eagerx::gen

#include "generator/tools/monitor/sparkline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace eagerx::gen {
namespace {

constexpr std::array<std::string_view, 8> kBlocks = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::array<std::string_view, 8> kAscii = {"_", ".", ",", "-", "=", "+", "*", "#"};

}  // namespace

std::string sparkline(const std::deque<float>& values, std::size_t columns, bool unicode) {
  const std::size_t count = std::min(values.size(), columns);
  const auto first = values.end() - static_cast<std::ptrdiff_t>(count);
  float low = HUGE_VALF, high = -HUGE_VALF;
  for (auto value = first; value != values.end(); ++value) {
    if (!std::isfinite(*value)) continue;
    low = std::min(low, *value);
    high = std::max(high, *value);
  }
  const auto& glyphs = unicode ? kBlocks : kAscii;
  std::string text(columns - count, ' ');
  for (auto value = first; value != values.end(); ++value) {
    if (!std::isfinite(*value)) {
      text += '?';
      continue;
    }
    // In double: the range of floats may be none of float.
    const double range = double{high} - double{low};
    const double place = range > 0.0 ? (double{*value} - double{low}) / range : 0.0;
    text += glyphs[std::min<std::size_t>(static_cast<std::size_t>(place * 8.0), 7)];
  }
  return text;
}

}  // namespace eagerx::gen

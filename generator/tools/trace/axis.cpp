#include "generator/tools/trace/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eagerx::gen {

PlotRange time_range(const std::vector<PlotPanel>& panels) {
  double last = 0.0;
  for (const auto& panel : panels) {
    for (const auto& line : panel.lines) {
      for (const double time_s : line.time_s) last = std::max(last, time_s);
    }
  }
  return {0.0, last > 0.0 ? last : 1.0};
}

PlotRange value_range(const PlotPanel& panel) {
  bool any = false;
  PlotRange range{0.0, 0.0};
  for (const auto& line : panel.lines) {
    for (const double value : line.value) {
      range.low = any ? std::min(range.low, value) : value;
      range.high = any ? std::max(range.high, value) : value;
      any = true;
    }
  }
  // Halves, so that the range of the largest doubles is one, too.
  const double half = 0.5 * range.high - 0.5 * range.low;
  const double least = 1e-9 * std::max({1.0, std::abs(range.low), std::abs(range.high)});
  if (half < least) return {range.low - 0.5 - least, range.high + 0.5 + least};
  return range;
}

std::vector<PlotMark> marks_of(const PlotRange& range, int wanted) {
  const double span = range.high - range.low;
  if (!std::isfinite(span) || span <= 0.0) return {};
  const double power = std::pow(10.0, std::floor(std::log10(span / wanted)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power * wanted >= span) {
      step = factor * power;
      break;
    }
  }
  std::vector<PlotMark> marks;
  const double first = std::ceil(range.low / step - 1e-9);
  for (int i = 0; i <= 2 * wanted; ++i) {
    const double value = (first + i) * step;
    if (value > range.high + 1e-9 * span) break;
    marks.push_back({value, fmt::format("{:.6g}", value + 0.0)});  // no -0
  }
  return marks;
}

std::vector<std::size_t> thinned(const PlotLine& line, const PlotRange& time, std::size_t columns) {
  std::vector<std::size_t> kept;
  const auto column = [&](std::size_t i) {
    return static_cast<std::size_t>(time.share(line.time_s[i]) * static_cast<double>(columns));
  };
  for (std::size_t i = 0; i < line.value.size();) {
    std::size_t end = i + 1;
    while (end < line.value.size() && column(end) == column(i)) ++end;
    const auto [low, high] =
        std::minmax_element(line.value.begin() + static_cast<std::ptrdiff_t>(i),
                            line.value.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<std::size_t> points = {i, static_cast<std::size_t>(low - line.value.begin()),
                                       static_cast<std::size_t>(high - line.value.begin()),
                                       end - 1};
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    kept.insert(kept.end(), points.begin(), points.end());
    i = end;
  }
  return kept;
}

}  // namespace eagerx::gen

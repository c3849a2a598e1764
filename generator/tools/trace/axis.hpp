// Maps values to places in a plot, and chooses the numbers on its axes.
#pragma once

#include <string>
#include <vector>

#include "generator/tools/trace/plot.hpp"

namespace eagerx::gen {

struct PlotRange {
  double low = 0.0, high = 1.0;
  double share(double value) const { return (value - low) / (high - low); }  // 0 to 1
};

/// From 0 to the last message of all panels.
PlotRange time_range(const std::vector<PlotPanel>& panels);
/// All values of a panel, and a little above and below where they are all the same.
PlotRange value_range(const PlotPanel& panel);

struct PlotMark {
  double value;
  std::string text;
};
/// About `wanted` multiples of 1, 2 or 5 times a power of ten.
std::vector<PlotMark> marks_of(const PlotRange& range, int wanted);

/// Indices of the points that are seen on `columns` columns: first, least, greatest and last of
/// each, in the order of time.
std::vector<std::size_t> thinned(const PlotLine& line, const PlotRange& time, std::size_t columns);

}  // namespace eagerx::gen

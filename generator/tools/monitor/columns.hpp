// The table of the screen: the columns that fit, and their contents. Inside monitor/ only.
#pragma once

#include "generator/tools/monitor/screen_lines.hpp"

namespace eagerx::gen {

/// Widths; 0: there is no such column.
struct TableColumns {
  std::size_t name = 0, value = 0, plot = 0, rate = 0, age = 0, limit = 0;
};
TableColumns table_columns(std::size_t columns);

ScreenLine table_head(const TableColumns& widths);
ScreenLine table_row(const Model& model, const WatchedChannel& channel, const TableColumns& widths,
                     bool selected, bool unicode);

/// The page of one channel: its facts, then a row for each element from `first` on.
std::vector<ScreenLine> zoomed_lines(const Model& model, const WatchedChannel& channel,
                                     std::size_t first, std::size_t rows, const ScreenSize& size);

}  // namespace eagerx::gen

#include "generator/tools/monitor/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/tools/monitor/numbers.hpp"
#include "generator/tools/monitor/sparkline.hpp"

namespace eagerx::gen {
namespace {

std::string percent(double share) {
  return fmt::format("{:.0f}%", std::clamp(share, -9.99, 9.99) * 100.0);
}

std::string values_text(const WatchedChannel& channel, std::size_t columns) {
  if (channel.values.empty()) return "-";
  if (channel.elements == 1) return short_text(channel.values.front(), columns);
  constexpr std::size_t kOfEach = 6;
  std::string text;
  for (const double value : channel.values) {
    if (text.size() > columns) break;
    text += (text.empty() ? "" : " ") + short_text(value, kOfEach);
  }
  return text;
}

std::string rate_cell(const WatchedChannel& channel, const ChannelState& state) {
  return fmt::format("{}/{}", state.measured_hz ? rate_text(*state.measured_hz) : "-",
                     channel.planned_hz ? rate_text(*channel.planned_hz) : "-");
}

std::string limit_cell(const WatchedChannel& channel, const ChannelState& state) {
  if (state.is_safe) return "safe";
  if (!state.limit) return {};
  const std::string element =
      channel.values.size() > 1 ? fmt::format("[{}]", state.limit->element) : "";
  return fmt::format("{}{} {}", state.limit->is_high ? "high" : "low", element,
                     percent(state.limit->left));
}

std::string bound_text(const std::vector<double>& bounds) {
  constexpr std::size_t kRoom = 10;
  return bounds.empty() ? "-" : short_text(bounds.front(), kRoom);
}

/// Columns of a row for an element; 0: there is none.
struct ElementColumns {
  std::size_t index = 6, number = 12, plot = 0, bound = 0, left = 6;
};
ElementColumns element_columns(std::size_t columns) {
  constexpr std::size_t kBound = 10, kRoomForBounds = 64;
  ElementColumns widths;
  if (columns >= kRoomForBounds) widths.bound = kBound;
  const std::size_t bounds = widths.bound > 0 ? 2 * (widths.bound + 1) : 0;
  widths.plot = columns - (widths.index + widths.number + widths.left + 3) - bounds;
  return widths;
}

ScreenLine element_head(std::size_t columns) {
  const ElementColumns widths = element_columns(columns);
  std::string text = fitted("ELEM", widths.index, true) + " " +
                     fitted("VALUE", widths.number, true) + " " + fitted("LAST", widths.plot) + " ";
  if (widths.bound > 0)
    text += fitted("LOW", widths.bound, true) + " " + fitted("HIGH", widths.bound, true) + " ";
  return {{text + fitted("LEFT", widths.left, true), Ink::head}};
}

ScreenLine element_line(const WatchedChannel& channel, std::size_t i, const ScreenSize& size) {
  const ElementColumns widths = element_columns(size.columns);
  const std::string plot =
      i < channel.history.size() ? sparkline(channel.history[i], widths.plot, size.unicode) : "";
  ScreenLine line = {{fitted(fmt::format("{}", i), widths.index, true) + " " +
                      fitted(short_text(channel.values[i], widths.number), widths.number, true) +
                      " " + fitted(plot, widths.plot) + " "}};
  std::vector<double> low, high;  // of this element
  if (channel.expected != nullptr) {
    if (i < channel.expected->low.size()) low = {channel.expected->low[i]};
    if (i < channel.expected->high.size()) high = {channel.expected->high[i]};
  }
  if (widths.bound > 0)
    line.push_back({fitted(bound_text(low), widths.bound, true) + " " +
                        fitted(bound_text(high), widths.bound, true) + " ",
                    Ink::dim});
  const auto limit = nearest_limit({channel.values[i]}, low, high);
  line.push_back({fitted(limit ? percent(limit->left) : "", widths.left, true),
                  limit && limit->left <= kNearLimit ? Ink::warning : Ink::plain});
  return line;
}

}  // namespace

TableColumns table_columns(std::size_t columns) {
  constexpr std::size_t kValue = 12, kRate = 9, kAge = 7, kLimit = 12;
  constexpr std::size_t kName = 20, kMostName = 44, kPlot = 8;
  TableColumns widths;
  std::size_t left = columns - 1;  // the mark of the selected row
  const auto take = [&](std::size_t& width, std::size_t wanted) {
    if (left < kName + 1 + wanted) return;
    width = wanted;
    left -= wanted + 1;
  };
  take(widths.value, kValue);
  take(widths.rate, kRate);
  take(widths.age, kAge);
  take(widths.plot, kPlot);
  take(widths.limit, kLimit);
  widths.name = left;
  // Once names have enough room, the plot gets part of the rest.
  constexpr std::size_t kUsualName = 26;
  if (widths.plot > 0 && left > kUsualName) {
    const std::size_t over = (left - kUsualName) * 2 / 3;
    widths.name = std::min(left - over, kMostName);
    widths.plot += left - widths.name;
  }
  return widths;
}

ScreenLine table_head(const TableColumns& widths) {
  std::string text = " " + fitted("CHANNEL", widths.name);
  if (widths.value > 0) text += " " + fitted("VALUE", widths.value, true);
  if (widths.plot > 0) text += " " + fitted("LAST", widths.plot);
  if (widths.rate > 0) text += " " + fitted("HZ/PLAN", widths.rate, true);
  if (widths.age > 0) text += " " + fitted("AGE", widths.age, true);
  if (widths.limit > 0) text += " " + fitted("LIMIT", widths.limit);
  return {{text, Ink::head}};
}

ScreenLine table_row(const Model& model, const WatchedChannel& channel, const TableColumns& widths,
                     bool selected, bool unicode) {
  const ChannelState state = model.state(channel);
  ScreenLine line = {{(selected ? ">" : " ") + fitted(channel.name, widths.name)}};
  const Ink plain = state.has_come ? Ink::plain : Ink::dim;
  line.front().ink = plain;
  const auto add = [&](std::size_t width, const std::string& text, Ink ink, bool to_the_right) {
    if (width == 0) return;
    line.push_back({" "});
    line.push_back({fitted(text, width, to_the_right), ink});
  };
  const std::deque<float> none;
  const auto& history = channel.history.empty() ? none : channel.history.front();
  add(widths.value, state.has_come ? values_text(channel, widths.value) : "missing", plain,
      channel.elements <= 1);
  add(widths.plot, sparkline(history, widths.plot, unicode), plain, false);
  add(widths.rate, rate_cell(channel, state), state.is_off_rate ? Ink::warning : plain, true);
  add(widths.age, state.age_s ? duration_text(*state.age_s) : "-",
      state.is_silent ? Ink::warning : plain, true);
  add(widths.limit, limit_cell(channel, state),
      state.is_at_limit() || state.is_safe ? Ink::warning : plain, false);
  if (selected) {
    for (InkedText& part : line) part.ink = Ink::selected;
  }
  return line;
}

std::vector<ScreenLine> zoomed_lines(const Model& model, const WatchedChannel& channel,
                                     std::size_t first, std::size_t rows, const ScreenSize& size) {
  const ChannelState state = model.state(channel);
  std::vector<ScreenLine> lines = {{{fitted(" " + channel.name, size.columns), Ink::title}}};
  std::string facts =
      fmt::format(" {} Hz, age {}, late {}, worst {}, {} messages, {}", rate_cell(channel, state),
                  state.age_s ? duration_text(*state.age_s) : "-",
                  duration_text(static_cast<double>(channel.late_ns) / kNsInSecond),
                  duration_text(static_cast<double>(channel.worst_ns) / kNsInSecond),
                  channel.messages, state.words());
  lines.push_back({{fitted(facts, size.columns)}});
  lines.push_back(element_head(size.columns));
  for (std::size_t i = first; i < channel.values.size() && lines.size() < rows; ++i)
    lines.push_back(element_line(channel, i, size));
  return lines;
}

}  // namespace eagerx::gen

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "generator/support/quote/quote.hpp"
#include "generator/tools/trace/convert.hpp"
#include "generator/tools/trace/timeline.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;

/// Names come from a file: quoted as RFC 4180 says where they have to be.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Columns of a channel begin at `first[channel]`.
std::string header(const Log& log, std::vector<std::size_t>& first) {
  std::string text = "episode,time_s";
  std::size_t columns = 0;
  for (const auto& channel : log.channels) {
    first.push_back(columns);
    columns += channel.size;
    for (std::uint64_t i = 0; i < channel.size; ++i) {
      text += "," + csv_cell(column_name(channel, i));
    }
  }
  first.push_back(columns);
  return text + "\n";
}

}  // namespace

std::string trace_csv(const Log& log) {
  const Timeline timeline = timeline_of(log);
  std::vector<std::size_t> first;
  std::string text = header(log, first);
  std::vector<std::size_t> order(log.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto instant = [&](std::size_t i) {
    return std::tuple(log.rows[i].episode, timeline.in_episode_ns[i]);
  };
  std::ranges::stable_sort(order, {}, instant);
  std::vector<std::string> cells(first.back());
  for (std::size_t i = 0; i < order.size();) {
    const auto now = instant(order[i]);
    std::ranges::fill(cells, std::string());
    for (; i < order.size() && instant(order[i]) == now; ++i) {
      const auto& row = log.rows[order[i]];
      const auto& channel = log.channels[row.channel];
      for (std::uint64_t k = 0; k < channel.size; ++k)
        cells[first[row.channel] + k] = trace_log::text_of(channel.dtype, log.values_of(row)[k]);
    }
    text += fmt::format("{},{:.9f}", std::get<0>(now), static_cast<double>(std::get<1>(now)) / 1e9);
    for (const auto& cell : cells) text += "," + cell;
    text += '\n';
  }
  return text;
}

}  // namespace eagerx::gen

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/base/number.hpp>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/tools/trace/plot.hpp"
#include "generator/tools/trace/timeline.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;

std::vector<host::Named> names_of(const Log& log, const Naming& naming) {
  std::vector<host::Named> known;
  for (const auto& channel : log.channels) {
    known.push_back({channel.name, channel.name});
    known.push_back({channel.name.substr(0, channel.name.rfind('/')), channel.name, false});
  }
  for (const host::Named& port : naming.ports)
    if (log.channel(port.of)) known.push_back(port);
  return known;
}

}  // namespace

std::optional<std::uint32_t> channel_named(const Log& log, const std::string& name,
                                           Naming& naming) {
  const std::vector<host::Named> known = names_of(log, naming);
  const std::string* const meant = host::name_meant(name, known);
  if (meant == nullptr) {
    naming.problem = fmt::format("there is no channel `{}` in `{}`\nhelp: {}", name, log.path,
                                 host::suggestion(name, known));
    return std::nullopt;
  }
  if (*meant != name)
    naming.note +=
        fmt::format("{}`{}` is `{}` here", naming.note.empty() ? "" : "\nnote: ", name, *meant);
  return log.channel(*meant);
}

PlotPanel panel_of(const Log& log, std::uint32_t channel, std::optional<std::uint32_t> episode) {
  const Timeline timeline = timeline_of(log);
  const auto& of = log.channels[channel];
  PlotPanel panel{of.name, of.size, {}, {}, {of.name}};
  for (std::uint64_t k = 0; of.size > 1 && k < of.size; ++k)
    panel.names.push_back(fmt::format("[{}]", k));
  std::size_t first = 0;  // line of the episode's element 0
  for (std::size_t i = 0; i < log.rows.size(); ++i) {
    const auto& row = log.rows[i];
    if (row.channel != channel || (episode && row.episode != *episode)) continue;
    if (panel.lines.empty() || panel.lines.back().episode != row.episode) {
      first = panel.lines.size();
      for (std::uint64_t k = 0; k < of.size; ++k) panel.lines.push_back({row.episode, k, {}, {}});
    }
    for (std::uint64_t k = 0; k < of.size; ++k) {
      const double value = trace_log::number_of(of.dtype, log.values_of(row)[k]);
      if (!std::isfinite(value)) continue;
      panel.lines[first + k].time_s.push_back(static_cast<double>(timeline.in_episode_ns[i]) / 1e9);
      panel.lines[first + k].value.push_back(value);
    }
  }
  return panel;
}

namespace {

/// Where the index of an element begins behind a channel's name; npos: there is none. Brackets
/// before the last part are of an array: `leg[0]/theta`.
std::size_t index_of(const std::string& name) {
  if (!name.ends_with(']')) return std::string::npos;
  const std::size_t part = name.find_last_of("/.");
  return name.find('[', part == std::string::npos ? 0 : part);
}

/// A channel, or one element of it.
std::optional<PlotPanel> one_named(const Log& log, const std::string& name,
                                   std::optional<std::uint32_t> episode, Naming& naming) {
  const std::size_t bracket = index_of(name);
  Naming of_array{naming.ports};  // `smooth[0]` may be a part of `smooth[0]/filtered`
  if (bracket != std::string::npos) {
    if (const auto channel = channel_named(log, name, of_array)) {
      naming.note += (naming.note.empty() ? "" : "\n") + of_array.note;
      return panel_of(log, *channel, episode);
    }
  }
  const auto channel = channel_named(log, name.substr(0, bracket), naming);
  if (!channel) return std::nullopt;
  PlotPanel panel = panel_of(log, *channel, episode);
  if (bracket == std::string::npos) return panel;
  std::uint64_t element = 0;
  const bool is_number =
      host::read_number(name.substr(bracket + 1, name.size() - bracket - 2), element);
  if (!is_number || element >= panel.elements) {
    naming.problem = fmt::format(
        "`{}` has no element `{}`\nhelp: its elements are {}[0]{}", panel.title,
        name.substr(bracket), panel.title,
        panel.elements == 1
            ? ""
            : fmt::format(" to {}[{}]{}", panel.title, panel.elements - 1,
                          is_number ? "" : ": one number, counted row by row, for each element"));
    return std::nullopt;
  }
  std::erase_if(panel.lines, [&](const PlotLine& line) { return line.element != element; });
  for (PlotLine& line : panel.lines) line.element = 0;
  panel.title += name.substr(bracket);
  panel.elements = 1;
  panel.names.clear();
  return panel;
}

/// `added` into the panel of those before it.
void lay_over(PlotPanel added, PlotPanel& panel) {
  const auto name_all = [](PlotPanel& one) {
    for (std::string& name : one.names) name = one.title + name;
    if (one.names.empty()) one.names = {one.title};
  };
  name_all(added);
  for (PlotLine& line : added.lines) {
    line.element += panel.elements;
    panel.lines.push_back(std::move(line));
  }
  panel.elements += added.elements;
  panel.title += (panel.title.empty() ? "" : ", ") + added.title;
  panel.names.insert(panel.names.end(), added.names.begin(), added.names.end());
  panel.channels.insert(panel.channels.end(), added.channels.begin(), added.channels.end());
}

/// The comma behind the name that begins there, or the end; commas in brackets are of an index.
std::size_t end_of_name(const std::string& names, std::size_t begin) {
  int depth = 0;
  for (std::size_t i = begin; i < names.size(); ++i) {
    if (names[i] == '[') ++depth;
    if (names[i] == ']') --depth;
    if (names[i] == ',' && depth <= 0) return i;
  }
  return names.size();
}

}  // namespace

std::optional<PlotPanel> panel_named(const Log& log, const std::string& name,
                                     std::optional<std::uint32_t> episode, Naming& naming) {
  std::optional<PlotPanel> panel;
  std::size_t begin = 0;
  while (begin <= name.size()) {
    const std::size_t end = end_of_name(name, begin);
    auto one = one_named(log, name.substr(begin, end - begin), episode, naming);
    if (!one) return std::nullopt;
    begin = end + 1;
    if (!panel && end == name.size()) return one;
    if (!panel) panel.emplace(PlotPanel{"", 0, {}, {}});
    lay_over(std::move(*one), *panel);
  }
  return panel;
}

}  // namespace eagerx::gen

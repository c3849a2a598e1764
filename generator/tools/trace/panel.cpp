#include <algorithm>
#include <cmath>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/tools/trace/plot.hpp"
#include "generator/tools/trace/timeline.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;

/// Parts between slashes.
std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (c == '/')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

bool has_parts(const std::string& channel, const std::vector<std::string>& wanted) {
  const std::vector<std::string> parts = parts_of(channel);
  // std::ranges' answers with a view, which clang 14 does not compile with GCC 12's library.
  return std::search(parts.begin(), parts.end(), wanted.begin(), wanted.end()) != parts.end();
}

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "`" : ", `") + name + "`";
  return text;
}

}  // namespace

std::optional<std::uint32_t> channel_named(const Log& log, const std::string& name,
                                           std::string& problem) {
  if (const auto exact = log.channel(name)) return exact;
  std::vector<std::uint32_t> fitting;
  std::vector<std::string> names, all;
  for (std::uint32_t c = 0; c < log.channels.size(); ++c) {
    all.push_back(log.channels[c].name);
    if (!has_parts(all.back(), parts_of(name))) continue;
    fitting.push_back(c);
    names.push_back(all.back());
  }
  if (fitting.size() == 1) return fitting.front();
  if (!fitting.empty()) {
    problem = "`" + name + "` may be " + list_of(names);
    return std::nullopt;
  }
  problem = "there is no channel `" + name + "` in `" + log.path + "`";
  const std::string near = nearest(name, all);
  problem += near.empty() ? "\nhelp: there are " + list_of(all) : "\nhelp: is it `" + near + "`?";
  return std::nullopt;
}

PlotPanel panel_of(const Log& log, std::uint32_t channel, std::optional<std::uint32_t> episode) {
  const Timeline timeline = timeline_of(log);
  const auto& of = log.channels[channel];
  PlotPanel panel{of.name, of.size, {}};
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

}  // namespace eagerx::gen

#include <cmath>
#include <runtime/host/base/nearest.hpp>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/tools/trace/plot.hpp"
#include "generator/tools/trace/timeline.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "`" : ", `") + name + "`";
  return text;
}

}  // namespace

std::optional<std::uint32_t> channel_named(const Log& log, const std::string& name,
                                           std::string& problem) {
  std::vector<std::string> all;
  for (const auto& channel : log.channels) all.push_back(channel.name);
  if (const std::string* const meant = host::name_meant(name, all))
    return static_cast<std::uint32_t>(meant - all.data());
  std::vector<std::string> fitting;
  for (const std::string* const each : host::with_parts_of(name, all)) fitting.push_back(*each);
  if (!fitting.empty()) {
    problem = "`" + name + "` may be " + list_of(fitting);
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

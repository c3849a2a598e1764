// Channels of a log over time, as a picture or as text.
#pragma once

#include <cstdint>
#include <optional>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <vector>

namespace eagerx::gen {

/// One number of a channel in one episode. Times and values that are not finite are left out.
struct PlotLine {
  std::uint32_t episode = 0;
  std::uint64_t element = 0;
  std::vector<double> time_s, value;  // of the same length; time in the episode
};

/// A channel with all its lines, one element of it, or several channels over each other.
struct PlotPanel {
  std::string title;
  std::uint64_t elements = 1;           // of all channels
  std::vector<std::string> names = {};  // of each element, in the legend; empty: one without
  std::vector<PlotLine> lines;
  std::vector<std::string> channels = {};  // whose they are
  std::string unit = {};                   // of all of them; empty: not known
};

/// Problems of names of channels.
struct Naming {
  std::vector<host::Named> ports = {};  // names besides those of the log
  std::string problem = {}, note = {};
};

/// The channel that `name` means: its whole name, or the only one that has all its parts in their
/// order ("theta", "pendulum/theta"). nullopt: the problem says why, and which there are.
std::optional<std::uint32_t> channel_named(const trace_log::Log& log, const std::string& name,
                                           Naming& naming);

/// `episode`: only this one; without: all.
PlotPanel panel_of(const trace_log::Log& log, std::uint32_t channel,
                   std::optional<std::uint32_t> episode);

/// The meaning of `name`: a channel, one element of it (`pose[3]`), or several with commas, in one
/// panel. nullopt: as channel_named().
std::optional<PlotPanel> panel_named(const trace_log::Log& log, const std::string& name,
                                     std::optional<std::uint32_t> episode, Naming& naming);

/// Panels below each other, with the same time. Long lines are thinned to the least and the
/// greatest value of each column of pixels. The same bytes on every machine.
std::string plot_svg(const std::vector<PlotPanel>& panels, const std::string& title);

/// The same in lines of `columns` characters: of Braille, or where a terminal has none of ASCII.
std::string plot_text(const std::vector<PlotPanel>& panels, std::size_t columns, bool braille);

}  // namespace eagerx::gen

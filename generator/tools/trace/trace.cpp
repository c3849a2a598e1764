#include "generator/tools/trace/trace.hpp"

#include <fmt/format.h>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/trace/convert.hpp"
#include "generator/tools/trace/plot.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;

/// f(log, result) for a log that can be read.
template <class F>
TraceResult with_log(const std::string& path, F&& f) {
  TraceResult result;
  const auto log = trace_log::read_log_file(path, result.problem);
  if (!log) return result;
  result.readable = true;
  if (!log->complete) result.note = fmt::format("`{}` ends early, in line {}", path, log->lines);
  f(*log, result);
  return result;
}

using Units = std::map<std::string, std::string>;

std::string unit_of(const std::string& channel, const Units& units) {
  const auto unit = units.find(channel);
  return unit == units.end() ? std::string() : unit->second;
}

/// The unit that all channels of a panel have is that of its axis; different ones are in the
/// legend.
void add_units(PlotPanel& panel, const Units& units) {
  const std::string first = unit_of(panel.channels.front(), units);
  if (ranges::all_of(panel.channels,
                     [&](const auto& channel) { return unit_of(channel, units) == first; })) {
    panel.unit = first;
    return;
  }
  for (std::string& name : panel.names) {
    const std::string channel = name.substr(0, name.ends_with(']') ? name.rfind('[') : name.size());
    if (const std::string unit = unit_of(channel, units); !unit.empty())
      name += fmt::format(" [{}]", unit);
  }
}

std::vector<PlotPanel> panels_of(const Log& log, const PlotRequest& request, Naming& naming) {
  std::string& problem = naming.problem;
  std::vector<PlotPanel> panels;
  if (request.episode && *request.episode >= log.episodes()) {
    problem = fmt::format("error: there is no episode {} in `{}`, whose episodes are 0 to {}",
                          *request.episode, log.path, log.episodes() - 1);
    if (log.episodes() == 0) problem = fmt::format("error: `{}` has no messages", log.path);
    return panels;
  }
  std::string problems;
  for (const auto& name : request.channels) {
    if (auto panel = panel_named(log, name, request.episode, naming)) {
      add_units(*panel, request.units);
      panels.push_back(std::move(*panel));
    } else {
      problems += (problems.empty() ? "error: " : "\nerror: ") + problem;
    }
  }
  problem = problems;
  return panels;
}

template <class F>
TraceResult plot(const PlotRequest& request, F&& f) {
  return with_log(request.log, [&](const Log& log, TraceResult& result) {
    Naming naming{request.ports};
    const std::vector<PlotPanel> panels = panels_of(log, request, naming);
    result.problem = naming.problem;
    if (!naming.note.empty()) result.note += (result.note.empty() ? "" : "\nnote: ") + naming.note;
    if (!result.problem.empty()) return;
    result.bytes = f(log, panels);
    result.summary = counted(panels.size(), "channel");
  });
}

}  // namespace

TraceResult convert_log(const std::string& path, TraceFormat format) {
  return with_log(path, [&](const Log& log, TraceResult& result) {
    if (const std::string problem = why_not(log, format); !problem.empty()) {
      result.problem = fmt::format("error: `{}` {}", path, problem);
      return;
    }
    result.bytes = converted(log, format);
    result.summary =
        counted(log.rows.size(), "message") + " of " + counted(log.channels.size(), "channel");
  });
}

TraceResult plot_log_as_svg(const PlotRequest& request) {
  return plot(request, [&](const Log& log, const std::vector<PlotPanel>& panels) {
    return plot_svg(panels, request.episode
                                ? fmt::format("{}, episode {}", log.graph, *request.episode)
                                : log.graph + ", " + counted(log.episodes(), "episode"));
  });
}

TraceResult plot_log_as_text(const PlotRequest& request, std::size_t columns, bool braille) {
  return plot(request, [&](const Log& /*log*/, const std::vector<PlotPanel>& panels) {
    return plot_text(panels, columns, braille);
  });
}

}  // namespace eagerx::gen

// Traces that runs wrote with `--trace`, for other tools and for plots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <runtime/host/base/nearest.hpp>
#include <string>
#include <vector>

namespace eagerx::gen {

enum class TraceFormat : std::uint8_t {
  csv,   // a row for each instant of an episode
  json,  // events for Perfetto and chrome://tracing
  mcap,  // https://mcap.dev, messages in JSON
  npz    // arrays for numpy.load
};
/// By the end of the file's name.
std::optional<TraceFormat> trace_format_of(const std::string& path);

struct TraceResult {
  std::string problem;    // in lines; empty if there is none
  bool readable = false;  // whether the log is one
  std::string note;       // of a log that ends early, and names that are spelled otherwise
  std::string bytes;      // of the file, or text
  std::string summary;    // "620 messages of 9 channels"
};

/// The log in the file `path`; the same bytes on every machine.
TraceResult convert_log(const std::string& path, TraceFormat format);

/// The channels to draw: channels by their whole names, or by parts that only one of them has
/// ("theta", "pendulum/theta").
struct PlotRequest {
  std::string log;
  std::vector<std::string> channels;
  std::optional<std::uint32_t> episode;           // without: all
  std::map<std::string, std::string> units = {};  // of channels, where one is known
  std::vector<host::Named> ports = {};            // as a graph calls channels
};
TraceResult plot_log_as_svg(const PlotRequest& request);
/// In lines of `columns` characters: of Braille, or where a terminal has none of ASCII.
TraceResult plot_log_as_text(const PlotRequest& request, std::size_t columns, bool braille);

}  // namespace eagerx::gen

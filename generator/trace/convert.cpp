#include "generator/trace/convert.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/quote/quote.hpp"

namespace eagerx::gen {

std::optional<TraceFormat> trace_format_of(const std::string& path) {
  if (path.ends_with(".csv")) return TraceFormat::csv;
  if (path.ends_with(".json")) return TraceFormat::json;
  if (path.ends_with(".mcap")) return TraceFormat::mcap;
  if (path.ends_with(".npz")) return TraceFormat::npz;
  return std::nullopt;
}

std::string why_not(const trace_log::Log& log, TraceFormat format) {
  // Four arrays a channel; 16 bits count them. Sizes have 32 bits, and a row is at most 32 bytes
  // besides its values.
  constexpr std::size_t kMostArrays = 65'535, kMostBytes = 0xffff'0000;
  const bool npz = format == TraceFormat::npz;
  if (npz && (log.channels.size() * 4 > kMostArrays ||
              log.rows.size() * 32 + log.values.size() * 8 > kMostBytes))
    return "is too large for npz: write csv or mcap";
  if (format == TraceFormat::mcap && log.channels.size() >= kMostArrays)
    return fmt::format("has {} channels, and MCAP has at most {}", log.channels.size(),
                       kMostArrays - 1);
  return {};
}

std::string quoted_json(const std::string& text) {
  return "\"" + in_json_string(text) + "\"";
}

std::string converted(const trace_log::Log& log, TraceFormat format) {
  switch (format) {
    case TraceFormat::csv:
      return trace_csv(log);
    case TraceFormat::json:
      return trace_json(log);
    case TraceFormat::mcap:
      return trace_mcap(log);
    case TraceFormat::npz:
      break;
  }
  return trace_npz(log);
}

std::string json_values(const trace_log::Log& log, const trace_log::Row& row) {
  const auto& channel = log.channels[row.channel];
  const std::uint64_t* const values = log.values_of(row);
  const auto number = [&](std::uint64_t bits) {
    if (!std::isfinite(trace_log::number_of(channel.dtype, bits))) return std::string("null");
    if (channel.dtype == trace_log::Dtype::boolean)
      return std::string(bits != 0 ? "true" : "false");
    return trace_log::text_of(channel.dtype, bits);
  };
  if (channel.size == 1) return number(values[0]);
  std::string text = "[";
  for (std::uint64_t i = 0; i < channel.size; ++i) {
    if (i > 0) text += ',';
    text += number(values[i]);
  }
  return text + "]";
}

}  // namespace eagerx::gen

#include "generator/tools/trace/convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <runtime/host/trace/json_text.hpp>
#include <vector>

#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {

std::optional<TraceFormat> trace_format_of(const std::string& path) {
  if (path.ends_with(".csv")) return TraceFormat::csv;
  if (path.ends_with(".json")) return TraceFormat::json;
  if (path.ends_with(".mcap")) return TraceFormat::mcap;
  if (path.ends_with(".npz")) return TraceFormat::npz;
  return std::nullopt;
}

namespace {

/// Names of arrays and columns are made of those of channels: which two would be one.
class Names {
 public:
  bool add(const std::string& name, const std::string& channel) {
    const auto [first, added] = channels_.try_emplace(name, channel);
    if (!added) problem_ = fmt::format("has `{}` twice", name);
    if (!added && !first->second.empty())
      problem_ += fmt::format(", of the channels `{}` and `{}`", first->second, channel);
    return added;
  }
  const std::string& problem() const { return problem_; }

 private:
  std::map<std::string, std::string> channels_;  // by name; empty: of none
  std::string problem_;
};

/// Programs that unpack a zip file may take its names for paths.
bool leads_away(std::string_view name) {
  for (std::size_t from = 0; from <= name.size();) {
    const std::size_t to = std::min(name.find('/', from), name.size());
    const std::string_view part = name.substr(from, to - from);
    if (part.empty() || part == "." || part == "..") return true;
    from = to + 1;
  }
  return false;
}

std::string why_no_arrays(const trace_log::Log& log) {
  Names names;
  for (const auto& [name, dtype, size, num, den] : log.channels) {
    if (leads_away(name))
      return fmt::format("has the channel `{}`, which is not a path in npz", name);
    for (const char* const part : {"", ".episode", ".tick", ".time_s"})
      if (!names.add(name + part, name)) return names.problem();
  }
  return {};
}

/// `columns`: besides those of channels.
std::string why_no_table(const trace_log::Log& log, const std::vector<std::string>& columns) {
  constexpr std::uint64_t kMostColumns = 1'000'000, kMostCells = 0xffff'0000;
  std::uint64_t count = 0;
  for (const auto& channel : log.channels) {
    count += std::min(channel.size, kMostColumns + 1);
    if (count > kMostColumns || count * log.rows.size() > kMostCells)
      return "is too large for csv: write npz or mcap";
  }
  Names names;
  for (const auto& column : columns) names.add(column, "");
  for (const auto& channel : log.channels) {
    for (std::uint64_t i = 0; i < channel.size; ++i)
      if (!names.add(column_name(channel, i), channel.name)) return names.problem();
  }
  return {};
}

}  // namespace

std::string column_name(const trace_log::RecordedChannel& channel, std::uint64_t element) {
  return channel.size == 1 ? channel.name : fmt::format("{}[{}]", channel.name, element);
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
  if (format == TraceFormat::csv) return why_no_table(log, {"episode", "time_s"});
  return npz ? why_no_arrays(log) : std::string();
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
  std::string text;
  trace_log::append_json_values(text, log.channels[row.channel], log.values_of(row));
  return text;
}

}  // namespace eagerx::gen

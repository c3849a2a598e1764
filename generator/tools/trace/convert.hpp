// Converts a log for other tools.
#pragma once

#include <runtime/host/trace/log_file.hpp>
#include <string>

#include "generator/tools/trace/trace.hpp"

namespace eagerx::gen {

/// The parts of a log that do not fit into such a file; empty if all fit.
std::string why_not(const trace_log::Log& log, TraceFormat format);

/// The bytes of the file; the same on every machine.
std::string converted(const trace_log::Log& log, TraceFormat format);

/// Of a table: "a/b", or "a/b[1]" of a message with several numbers.
std::string column_name(const trace_log::RecordedChannel& channel, std::uint64_t element);
/// Foreign text as a string of JSON.
std::string quoted_json(const std::string& text);
/// "[0.5,-1]" or, for a message with one number, "0.5". Numbers have the fewest digits that give
/// the same bits; non-finite numbers are null.
std::string json_values(const trace_log::Log& log, const trace_log::Row& row);

std::string trace_csv(const trace_log::Log& log);
std::string trace_json(const trace_log::Log& log);
std::string trace_mcap(const trace_log::Log& log);
std::string trace_npz(const trace_log::Log& log);

}  // namespace eagerx::gen

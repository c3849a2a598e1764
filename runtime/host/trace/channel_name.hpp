// Names of channels in a trace file, which is not trusted.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace eagerx::trace_log {

/// Programs have names of some ten bytes; formats that traces are converted to count to 65535.
inline constexpr std::size_t kMostNameBytes = 1000;

/// Why no row, table or other file can have such a name; empty if there is no reason.
std::string problem_with_channel_name(std::string_view name);

}  // namespace eagerx::trace_log

// Messages as JSON, from logs and from running programs.
#pragma once

#include <cstdint>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <string_view>

namespace eagerx::trace_log {

/// "[0.5,-1]" or, for a message with one number, "0.5". Numbers have the fewest digits that give
/// the same bits; non-finite numbers are null.
void append_json_values(std::string& to, const RecordedChannel& channel,
                        const std::uint64_t* values);
/// `{"episode":0,"tick":3,"value":0.5}`
void append_json_message(std::string& to, const RecordedChannel& channel, std::uint32_t episode,
                         std::uint64_t tick, const std::uint64_t* values);
/// JSON Schema of such a message.
std::string json_schema(const RecordedChannel& channel);

}  // namespace eagerx::trace_log

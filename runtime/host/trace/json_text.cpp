#include <cmath>
#include <runtime/host/trace/json_text.hpp>

namespace eagerx::trace_log {
namespace {

void append_value(std::string& to, Dtype dtype, std::uint64_t bits) {
  if (!std::isfinite(number_of(dtype, bits))) {
    to += "null";
  } else if (dtype == Dtype::boolean) {
    to += bits != 0 ? "true" : "false";
  } else {
    to += text_of(dtype, bits);
  }
}

}  // namespace

void append_json_values(std::string& to, const RecordedChannel& channel,
                        const std::uint64_t* values) {
  if (channel.size == 1) return append_value(to, channel.dtype, values[0]);
  to += '[';
  for (std::uint64_t i = 0; i < channel.size; ++i) {
    if (i > 0) to += ',';
    append_value(to, channel.dtype, values[i]);
  }
  to += ']';
}

void append_json_message(std::string& to, const RecordedChannel& channel, std::uint32_t episode,
                         std::uint64_t tick, const std::uint64_t* values) {
  to += "{\"episode\":" + std::to_string(episode) + ",\"tick\":" + std::to_string(tick) +
        ",\"value\":";
  append_json_values(to, channel, values);
  to += '}';
}

std::string json_schema(const RecordedChannel& channel) {
  const bool real = channel.dtype == Dtype::float32 || channel.dtype == Dtype::float64;
  const std::string one = real ? R"({"type":["number","null"]})"
                               : std::string(R"({"type":")") +
                                     (channel.dtype == Dtype::boolean ? "boolean" : "number") +
                                     "\"}";
  const std::string size = std::to_string(channel.size);
  const std::string value = channel.size == 1
                                ? one
                                : R"({"type":"array","items":)" + one + R"(,"minItems":)" + size +
                                      R"(,"maxItems":)" + size + "}";
  return R"({"type":"object","properties":{"episode":{"type":"integer"},"tick":{"type":"integer"},"value":)" +
         value + "}}";
}

}  // namespace eagerx::trace_log

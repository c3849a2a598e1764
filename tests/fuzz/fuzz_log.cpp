// Any bytes as the log of a run: no crash, and either a log or exactly one reason.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <runtime/host/trace/log_file.hpp>
#include <string_view>

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::string problem;
  const auto log = eagerx::trace_log::read_log("log", text, problem);
  if (log.has_value() != problem.empty()) std::abort();
  if (!log) return 0;
  for (const auto& row : log->rows) {
    const auto& channel = log->channels[row.channel];
    const std::uint64_t* const values = log->values_of(row);
    eagerx::trace_log::distance_text(channel.dtype, values[0], values[channel.size - 1]);
  }
  return 0;
}

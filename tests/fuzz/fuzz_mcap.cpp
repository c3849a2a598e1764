// Any bytes as an MCAP file, in one piece and in two: no crash, the same messages, and what is
// reported lies within the bytes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <runtime/host/trace/mcap_reader.hpp>
#include <string>
#include <string_view>

namespace {

using eagerx::trace_log::McapChannel;
using eagerx::trace_log::McapListener;
using eagerx::trace_log::McapMessage;
using eagerx::trace_log::McapReader;

struct Counts final : McapListener {
  std::size_t channels = 0, messages = 0, bytes = 0;
  void channel(const McapChannel& channel) override {
    ++channels;
    bytes += channel.topic.size();
  }
  void message(const McapMessage& message) override {
    ++messages;
    bytes += message.data.size();
  }
  bool operator==(const Counts& other) const {
    return channels == other.channels && messages == other.messages && bytes == other.bytes;
  }
};

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  Counts whole, parts;
  McapReader reader(whole), other(parts);
  std::string_view rest = all;
  const bool is_right = reader.read(rest);
  if (whole.bytes > size || is_right == !reader.problem().empty()) std::abort();
  std::string kept(all.substr(0, data[0] % size));
  rest = kept;
  bool is_other_right = other.read(rest);
  kept = std::string(rest) + std::string(all.substr(data[0] % size));
  rest = kept;
  if (is_other_right && !other.is_complete()) is_other_right = other.read(rest);
  if (is_right != is_other_right || !(whole == parts)) std::abort();
  return 0;
}

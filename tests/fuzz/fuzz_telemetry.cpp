// Bytes from the serial line of a board, and the layout to decode them.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <eagerx/link/telemetry.hpp>
#include <memory>
#include <runtime/host/telemetry/decoder.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "generator/tools/monitor/telemetry_layout.hpp"

namespace {

using namespace eagerx;

/// A shown record is of a known channel and has all of its values.
struct Listener : telemetry::Listener {
  explicit Listener(const telemetry::Layout& of) : layout(of) {}
  void message(const telemetry::Message& message) override {
    if (message.group >= layout.groups.size()) std::abort();
    const telemetry::Group& group = layout.groups[message.group];
    if (message.channel >= group.channels.size()) std::abort();
    for (std::uint64_t i = 0; i < group.channels[message.channel].size; ++i)
      sum += message.values[i];
  }
  void text(std::string_view text) override {
    for (const char letter : text) sum += static_cast<std::uint64_t>(letter);
  }
  const telemetry::Layout& layout;
  std::uint64_t sum = 0;
};

telemetry::Layout usual() {
  telemetry::Layout layout{"fuzzed", 1, 1, 115'200, {}};
  layout.groups.push_back({1000,
                           1,
                           2,
                           24,
                           {{"a/x", "a.x", trace_log::Dtype::float32, {3}, 3, 8},
                            {"a/on", "a.on", trace_log::Dtype::boolean, {}, 1, 20}}});
  layout.groups.push_back({100, 1, 1, 16, {{"b/n", "b.n", trace_log::Dtype::int64, {}, 1, 8}}});
  return layout;
}

void decode(const telemetry::Layout& layout, const std::vector<std::uint8_t>& line) {
  const auto decoder = std::make_unique<telemetry::Decoder>(layout);
  Listener listener(layout);
  // In pieces, which makes no difference.
  const std::size_t half = line.size() / 2;
  decoder->take(line.data(), half, listener);
  decoder->take(line.data() + half, line.size() - half, listener);
}

void add_frame(std::vector<std::uint8_t>& line, std::uint8_t kind, const std::uint8_t* bytes,
               std::size_t size, std::uint32_t crc_start) {
  auto frame = std::make_unique<link::ByteFrame<link::kMostRecordBytes>>();
  frame->begin(crc_start);
  std::uint8_t header[link::kHeaderBytes] = {kind};
  link::write_as(header + 1, static_cast<std::uint32_t>(line.size()));
  for (const std::uint8_t byte : header) frame->add(byte);
  for (std::size_t i = 0; i < size; ++i) frame->add(bytes[i]);
  frame->finish();
  while (!frame->offer([&](std::uint8_t byte) { return line.push_back(byte), true; })) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string problem;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto layout = gen::read_telemetry_layout(text, problem)) {
    decode(*layout, {data, data + size});
  } else if (problem.empty()) {
    std::abort();
  }
  const telemetry::Layout layout = usual();
  decode(layout, {data, data + size});
  // Greeted, and what comes is the payload of frames that are intact.
  link::Greeting greeting;
  greeting.graph = layout.hash;
  greeting.runtime = layout.runtime;
  std::uint8_t hello[link::kTelemetryGreetingBytes] = {};
  greeting.write(hello);
  std::vector<std::uint8_t> line;
  add_frame(line, link::kTelemetryGreeting, hello, sizeof hello, 0);
  for (std::size_t at = 0; at < size;) {
    const std::size_t rest = size - at - 1;
    const std::size_t length = data[at] < rest ? data[at] : rest;
    const std::uint8_t kind =
        length == sizeof hello ? link::kTelemetryGreeting : link::kTelemetryValues;
    add_frame(line, kind, data + at + 1, length,
              kind == link::kTelemetryValues ? greeting.crc_start() : 0);
    at += 1 + length;
  }
  decode(layout, line);
  return 0;
}

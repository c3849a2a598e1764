// Any bytes as a message of Foxglove's protocol, of a client and of a server, in text and in
// binary: no crash, and either one that is complete or a reason. What is JSON stays within its
// bounds.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <runtime/host/base/json_reader.hpp>
#include <runtime/host/foxglove/client_message.hpp>
#include <runtime/host/foxglove/server_message.hpp>
#include <string_view>
#include <vector>

namespace {

using eagerx::foxglove::ClientMessage;
using Json = eagerx::host::JsonValue;

void require(bool holds) {
  if (!holds) std::abort();
}

std::size_t count(const Json& value, int depth) {
  require(depth <= eagerx::host::kDeepestJson);
  std::size_t values = 1;
  require(value.names.empty() || value.names.size() == value.items.size());
  for (const Json& each : value.items) values += count(each, depth + 1);
  return values;
}

void check(const ClientMessage& message) {
  using MessageKind = ClientMessage::Kind;
  require((message.kind == MessageKind::wrong || message.kind == MessageKind::unsupported) ==
          !message.problem.empty());
}

/// Messages of a server, as `eagerx-gen monitor` reads it.
void check_server(std::string_view bytes) {
  using MessageKind = eagerx::foxglove::ServerMessage::Kind;
  static_cast<void>(eagerx::foxglove::read_server_text(bytes));
  const auto message = eagerx::foxglove::read_server_bytes(bytes);
  require(message.kind != MessageKind::data || message.time_ns >= 0);
  constexpr std::size_t kMost = 16;
  eagerx::foxglove::ChannelValue value;
  if (eagerx::foxglove::read_channel_value(bytes, kMost, value))
    require(value.values.size() <= kMost && value.values.size() <= value.elements);
  std::uint32_t episode = 0;
  std::vector<float> rows;
  if (eagerx::foxglove::read_drawing(bytes, episode, rows)) require(rows.size() % 16 == 0);
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check(eagerx::foxglove::read_client_text(text));
  check(eagerx::foxglove::read_client_bytes(text));
  eagerx::foxglove::steps_of_request(text);
  check_server(text);
  const auto json = eagerx::host::read_json(text);
  if (json) require(count(*json, 0) <= eagerx::host::kMostJsonValues);
  return 0;
}

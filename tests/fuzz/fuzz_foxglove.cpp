// Any bytes as a message of a client of Foxglove's protocol, in text and in binary: no crash, and
// either one that is complete or a reason. What is JSON stays within its bounds.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <targets/linux-sim/publish/foxglove/client_message.hpp>
#include <targets/linux-sim/publish/foxglove/json_reader.hpp>

namespace {

using eagerx::linux_sim::ClientMessage;
using eagerx::linux_sim::Json;

void require(bool holds) {
  if (!holds) std::abort();
}

std::size_t count(const Json& value, int depth) {
  require(depth <= eagerx::linux_sim::kDeepestJson);
  std::size_t values = 1;
  require(value.names.empty() || value.names.size() == value.items.size());
  for (const Json& each : value.items) values += count(each, depth + 1);
  return values;
}

void check(const ClientMessage& message) {
  using Said = ClientMessage::Kind;
  require((message.kind == Said::wrong || message.kind == Said::unsupported) ==
          !message.problem.empty());
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check(eagerx::linux_sim::read_client_text(text));
  check(eagerx::linux_sim::read_client_bytes(text));
  eagerx::linux_sim::steps_of_request(text);
  const auto json = eagerx::linux_sim::read_json(text);
  if (json) require(count(*json, 0) <= eagerx::linux_sim::kMostJsonValues);
  return 0;
}

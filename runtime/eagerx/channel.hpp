// What is known of a published message before the program runs.
#pragma once

#include <cstdint>

namespace eagerx {

/// Who publishes it.
enum class Publisher : std::uint8_t { environment, engine, engine_node, node };

/// One channel of the trace; its number is its place in Graph::kChannels.
struct Channel {
  const char* name;    // of the publisher's output: "node/output", "environment/action"
  const char* dtype;   // as graphs write it: "float32"
  std::uint64_t size;  // elements of a message
  std::uint64_t rate_num, rate_den;  // [Hz]
  Publisher publisher;
};

}  // namespace eagerx

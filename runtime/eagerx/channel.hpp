// Static properties of a published message.
#pragma once

#include <cstdint>

namespace eagerx {

/// The publisher of a channel.
enum class Publisher : std::uint8_t { environment, engine, engine_node, node };

/// One channel of the trace; its number is its place in Graph::kChannels.
struct Channel {
  const char* name;    // of the publisher's output: "node/output", "environment/action"
  const char* dtype;   // as graphs write it: "float32"
  std::uint64_t size;  // elements of a message
  std::uint64_t rate_num, rate_den;  // [Hz]
  Publisher publisher;
  // Its names in graphs: "smooth.filtered", "pendulum.theta", "actions.u", "arm.x, arm.same".
  const char* port = "";
  /// The bounds of its space, if any: `bounds` entries of Graph::kBounds from `first` on, one for
  /// all elements or one for each.
  std::uint32_t first = 0, bounds = 0;
};

/// Shape of a channel whose messages are not one number.
struct ChannelShape {
  std::uint32_t channel;
  const char* sizes;  // "4x3"
};

/// Name of a channel in the graph, if it is also a port of a composite.
struct ChannelAlias {
  std::uint32_t channel;
  const char* port;  // "robot.speed"
};

/// Inclusive, as in a Space. float32 is exact here; an int64 beyond 2^53 is rounded.
struct Bounds {
  double low, high;
};

}  // namespace eagerx

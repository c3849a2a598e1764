// Static properties of a published message.
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
  // As graphs call it: "smooth.filtered", "pendulum.theta", "actions.u", "arm.x, arm.same".
  const char* port = "";
  /// The bounds of its space, if it has any: in Graph::kBounds from `first` on, `bounds` of them,
  /// one for all elements or one for each.
  std::uint32_t first = 0, bounds = 0;
};

/// Of a channel whose messages are not one number.
struct ChannelShape {
  std::uint32_t channel;
  const char* sizes;  // "4x3"
};

/// Of a channel that is also a port of a composite, which is how the graph calls it.
struct ChannelAlias {
  std::uint32_t channel;
  const char* port;  // "robot.speed"
};

/// Inclusive, as in a Space. float32 is exact here; an int64 beyond 2^53 is rounded.
struct Bounds {
  double low, high;
};

}  // namespace eagerx

// The newest messages of a run, as the thread sees them that publishes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/channel.hpp>
#include <string>
#include <targets/linux-sim/message_view.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// The newest message of one channel.
struct LatestMessage {
  const Channel* channel = nullptr;
  std::string node, port;  // the two halves of its name
  Scalar scalar = Scalar::f32;
  std::size_t size = 0;          // elements
  std::vector<std::byte> bytes;  // of them
  bool is_there = false;         // in this episode
};

/// All that is published, behind a step.
struct Snapshot {
  std::uint32_t episode = 0;
  std::uint64_t step = 0;
  double time_s = 0.0;  // by the graph's clock, since the run began; episodes follow each other
  std::vector<LatestMessage> messages;  // those of a node stand together
};

/// The scalar type that a channel's `dtype` names.
Scalar scalar_of_dtype(const char* dtype);

/// Element `i` of a message in as few digits as keep it; `none` if it is not finite.
void append_number(std::string& to, const LatestMessage& message, std::size_t i, const char* none);

}  // namespace eagerx::linux_sim

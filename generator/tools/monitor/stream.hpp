// Events of a stream of messages, the same for all kinds of source.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <runtime/host/trace/log_file.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

// A stream is not trusted. These limits bound its memory: about 60 MB.
inline constexpr std::size_t kMostStreamChannels = 2'000;
inline constexpr std::size_t kMostStreamElements = 1'024;  // of a message; what follows is dropped

inline constexpr double kNsInSecond = 1e9;

/// The description of a stream. Without channels: messages define them.
struct StreamFacts {
  std::string graph, engine, agent;
  std::optional<std::uint64_t> hash;  // of the graph
  std::uint64_t seed = 0;
  std::uint32_t environment = 0;
  std::vector<trace_log::RecordedChannel> channels;
  std::vector<std::uint64_t> every;  // one of this many messages of a channel comes; empty: all
  bool timed_by_sender = false;      // StreamMessage::real_ns is of the sender's clock
  bool one_message_a_step = false;   // of each channel, the last one
  bool has_scenes = false;           // there is a drawing
};

struct StreamMessage {
  std::string_view channel;
  std::span<const double> values;       // at most kMostStreamElements
  const std::uint64_t* bits = nullptr;  // of all of them, as the trace hashes them; null: not known
  std::uint64_t elements = 0;           // that the message has
  std::uint32_t episode = 0;
  std::optional<std::uint64_t> seq =
      {};                    // of the channel, or the step where messages have no number
  std::int64_t time_ns = 0;  // of the graph's clock, without steps back between episodes
  /// When it was sent or came, by a clock of real time; nothing if unknown.
  std::optional<std::int64_t> real_ns = {};
  std::uint32_t part = 0;  // of the episode, where its times begin anew within it
};

struct StreamScene {
  std::uint32_t episode = 0;
  std::int64_t time_ns = 0;
  std::span<const float> rows;  // [rows][kSceneColumns], see eagerx/scene.hpp
};

struct StreamStep {
  std::uint32_t episode = 0;
  std::optional<std::uint64_t> step;  // where it is known
  std::int64_t time_ns = 0;
  std::optional<std::int64_t> real_ns = {};
};

/// A fault of a stream, or of its sender, that does not end it.
enum class StreamFault : std::uint8_t {
  damaged,      // no datagram, line or frame of eagerx-gen
  foreign,      // of another graph
  late,         // older than what came before
  lost,         // steps or records that did not come
  crowded_out,  // channels and elements beyond the bounds
  dropped,      // records for which the sender had no room, as it says
  late_slots    // that began after their deadline, as the sender says
};
inline constexpr std::size_t kStreamFaults = 7;

class StreamListener {
 public:
  virtual ~StreamListener() = default;
  /// Before the first message, and when another run or graph begins. False: the stream is refused,
  /// and ends here.
  virtual bool begin(const StreamFacts& facts) = 0;
  virtual void message(const StreamMessage& message) = 0;
  virtual void step(const StreamStep& step) = 0;
  virtual void fault(StreamFault fault, std::uint64_t count) = 0;
  /// The scene of `render:`; only for listeners that want it.
  virtual void scene(const StreamScene& /*scene*/) {}
  [[nodiscard]] virtual bool wants_scenes() const { return false; }
};

}  // namespace eagerx::gen

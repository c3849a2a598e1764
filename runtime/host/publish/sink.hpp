// Destination of published messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <vector>

namespace eagerx::publish {

struct PublishedMessage {
  std::uint32_t channel;
  std::uint32_t episode;
  std::uint64_t seq;
  std::int64_t time_ns;         // since the run began, without steps back between episodes
  const std::uint64_t* values;  // [size of the channel], the bits that the trace hashes
};
struct PublishedStep {
  std::uint32_t episode;
  std::uint64_t step;  // from 1; 0: a reset
  std::int64_t time_ns;
};
struct PublishedScene {
  std::uint32_t episode;
  std::int64_t time_ns;
  const float* rows;  // [count][16], see eagerx/scene.hpp
  std::size_t count;
};

/// One `--publish`. Only the publishing thread calls it, except open() and const functions. No call
/// may wait for a reader.
class PublishSink {
 public:
  virtual ~PublishSink() = default;
  /// Empty, or the problem.
  virtual std::string open() = 0;
  /// A note for the user, once it is open; empty: none.
  virtual std::string note() const { return {}; }
  virtual void message(const PublishedMessage& message) = 0;
  virtual void step(const PublishedStep& step) = 0;
  /// The scene of `render:`.
  virtual void scene(const PublishedScene& /*scene*/) {}
  /// Called every few milliseconds.
  virtual void idle() {}
  /// Call it after the last message. Empty, or the problem.
  virtual std::string close() { return {}; }

  /// Messages, or datagrams, that were not sent.
  std::uint64_t dropped() const { return dropped_; }
  std::uint64_t sent() const { return sent_; }
  /// Of the summary: "datagrams"
  virtual const char* unit() const = 0;
  /// … and further counts: ", 2 clients"
  virtual std::string more() const { return {}; }

 protected:
  std::uint64_t dropped_ = 0, sent_ = 0;
};

using PublishedChannels = std::vector<trace_log::RecordedChannel>;

}  // namespace eagerx::publish

// Reads MCAP files (https://mcap.dev/spec) from front to back, also growing files and those of
// other programs: channels and messages, inside or outside of uncompressed chunks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eagerx::trace_log {

struct McapChannel {
  std::uint16_t id = 0;
  std::string topic, encoding;
  std::vector<std::pair<std::string, std::string>> metadata;
};

struct McapMessage {
  std::uint16_t channel = 0;
  std::uint64_t time_ns = 0;  // when it was recorded
  std::string_view data;
};

class McapListener {
 public:
  virtual void channel(const McapChannel& channel) = 0;
  virtual void message(const McapMessage& message) = 0;

 protected:
  ~McapListener() = default;
};

class McapReader {
 public:
  explicit McapReader(McapListener& listener) : listener_(listener) {}

  /// Removes all complete records from the front of `bytes`; pass the rest again with the bytes
  /// that follow. False if it is not an MCAP file, or is damaged: see problem().
  bool read(std::string_view& bytes);
  /// Whether the end of the data was read; only indexes follow.
  bool is_complete() const { return is_complete_; }
  const std::string& problem() const { return problem_; }

 private:
  bool record(unsigned op, std::string_view content, bool in_chunk);
  bool read_channel(std::string_view content);
  bool read_chunk(std::string_view content);
  bool fail(std::string why) { return problem_ = std::move(why), false; }

  McapListener& listener_;
  bool has_magic_ = false, is_complete_ = false;
  std::string problem_;
};

}  // namespace eagerx::trace_log

// MCAP files, https://mcap.dev/spec: chunks without compression, each with its index; messages in
// JSON. `eagerx-gen trace convert` writes them from a log, and a program with `--publish mcap:FILE`
// while it runs.
#pragma once

#include <cstdint>
#include <map>
#include <runtime/host/base/crc32.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <utility>
#include <vector>

namespace eagerx::trace_log {

inline constexpr std::size_t kMostMcapChannels = 65'534;

/// The bytes of the file so far, except those taken away.
class McapFile {
 public:
  /// At most kMostMcapChannels, which must outlive this.
  explicit McapFile(const std::vector<RecordedChannel>& channels);

  /// `values`: [size of the channel]
  void add(std::uint32_t channel, std::uint32_t episode, std::uint64_t seq, std::int64_t time,
           const std::uint64_t* values);
  /// A file that ends after a chunk has all messages up to there.
  void end_chunk();
  bool has_messages() const { return chunk_messages_ > 0; }
  void finish();
  /// The bytes since the last call.
  std::string take() { return std::exchange(ready_, {}); }

 private:
  struct Place {
    std::uint64_t time_ns;
    std::uint64_t offset;
  };

  void write(const std::string& bytes);
  void write_chunk_index(std::uint64_t start);
  std::string statistics() const;

  const std::vector<RecordedChannel>& channels_;
  std::vector<std::uint64_t> counts_;  // of messages, by channel
  std::string ready_, chunk_, chunk_indexes_, message_;
  std::uint64_t size_ = 0;                             // of the file
  Crc32 crc_;                                          // of the file
  std::map<std::uint32_t, std::vector<Place>> index_;  // of the chunk, by channel
  std::uint64_t chunk_messages_ = 0, first_ns_ = 0, last_ns_ = 0, begin_ns_ = 0, end_ns_ = 0;
  std::uint32_t chunks_ = 0;
};

}  // namespace eagerx::trace_log

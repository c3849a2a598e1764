#include <algorithm>
#include <runtime/host/trace/json_text.hpp>
#include <runtime/host/trace/mcap.hpp>
#include <string_view>
#include <type_traits>

namespace eagerx::trace_log {
namespace {

enum Op : std::uint8_t {
  kHeader = 1,
  kFooter = 2,
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kMessageIndex = 7,
  kChunkIndex = 8,
  kStatistics = 11,
  kDataEnd = 15
};
constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::size_t kChunkBytes = 1 << 20;

/// Little-endian.
template <class T>
void append(std::string& to, T value) {
  static_assert(std::is_unsigned_v<T>);
  for (std::size_t i = 0; i < sizeof(T); ++i)
    to += static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i)));
}
void append_text(std::string& to, std::string_view text) {
  append(to, static_cast<std::uint32_t>(text.size()));
  to += text;
}
void append_record(std::string& to, Op op, std::string_view content) {
  append(to, static_cast<std::uint8_t>(op));
  append(to, std::uint64_t{content.size()});
  to += content;
}

std::uint16_t id_of(std::uint32_t channel) {
  return static_cast<std::uint16_t>(channel + 1);
}

/// Schemas and channels, in the data and again in the summary.
std::string definitions(const std::vector<RecordedChannel>& all) {
  std::string schemas, channels;
  for (std::uint32_t c = 0; c < all.size(); ++c) {
    const RecordedChannel& channel = all[c];
    std::string schema, record;
    append(schema, id_of(c));
    append_text(schema, channel.name);
    append_text(schema, "jsonschema");
    append_text(schema, json_schema(channel));
    append_record(schemas, kSchema, schema);
    append(record, id_of(c));
    append(record, id_of(c));
    append_text(record, "/" + channel.name);
    append_text(record, "json");
    std::string metadata;
    append_text(metadata, "rate_hz");
    append_text(metadata,
                std::to_string(channel.rate_num) + "/" + std::to_string(channel.rate_den));
    // JSON has one type of numbers.
    append_text(metadata, "dtype");
    append_text(metadata, name_of(channel.dtype));
    append_text(metadata, "size");
    append_text(metadata, std::to_string(channel.size));
    append_text(record, metadata);
    append_record(channels, kChannel, record);
  }
  return schemas + channels;
}

}  // namespace

McapFile::McapFile(const std::vector<RecordedChannel>& channels)
    : channels_(channels), counts_(channels.size()) {
  std::string begin(kMagic), header;
  append_text(header, "");
  append_text(header, "eagerx-gen");
  append_record(begin, kHeader, header);
  write(begin + definitions(channels));
}

void McapFile::write(const std::string& bytes) {
  ready_ += bytes;
  size_ += bytes.size();
  crc_.add(bytes);
}

void McapFile::add(std::uint32_t channel, std::uint32_t episode, std::uint64_t seq,
                   std::int64_t time, const std::uint64_t* values) {
  const auto time_ns = static_cast<std::uint64_t>(time);
  message_.clear();
  append(message_, id_of(channel));
  append(message_, static_cast<std::uint32_t>(seq));
  append(message_, time_ns);
  append(message_, time_ns);
  append_json_message(message_, channels_[channel], episode, seq, values);
  index_[channel].push_back({time_ns, chunk_.size()});
  append_record(chunk_, kMessage, message_);
  first_ns_ = chunk_messages_ == 0 ? time_ns : std::min(first_ns_, time_ns);
  last_ns_ = chunk_messages_++ == 0 ? time_ns : std::max(last_ns_, time_ns);
  ++counts_[channel];
  if (chunk_.size() >= kChunkBytes) end_chunk();
}

void McapFile::end_chunk() {
  if (chunk_messages_ == 0) return;
  const std::uint64_t start = size_;
  std::string chunk, record;
  append(chunk, first_ns_);
  append(chunk, last_ns_);
  append(chunk, std::uint64_t{chunk_.size()});
  append(chunk, crc32_of(chunk_));
  append_text(chunk, "");
  append(chunk, std::uint64_t{chunk_.size()});
  append_record(record, kChunk, chunk + chunk_);
  write(record);
  write_chunk_index(start);
  begin_ns_ = chunks_ == 0 ? first_ns_ : std::min(begin_ns_, first_ns_);
  end_ns_ = std::max(end_ns_, last_ns_);
  ++chunks_;
  chunk_.clear();
  index_.clear();
  chunk_messages_ = 0;
}

/// Of the chunk that begins at `start` and ends here.
void McapFile::write_chunk_index(std::uint64_t start) {
  const std::uint64_t after = size_;
  std::string offsets;
  for (const auto& [channel, places] : index_) {
    append(offsets, id_of(channel));
    append(offsets, size_);
    std::string entries, index, record;
    for (const Place& place : places) {
      append(entries, place.time_ns);
      append(entries, place.offset);
    }
    append(index, id_of(channel));
    append_text(index, entries);
    append_record(record, kMessageIndex, index);
    write(record);
  }
  std::string record;
  append(record, first_ns_);
  append(record, last_ns_);
  append(record, start);
  append(record, after - start);
  append_text(record, offsets);
  append(record, size_ - after);
  append_text(record, "");
  append(record, std::uint64_t{chunk_.size()});
  append(record, std::uint64_t{chunk_.size()});
  append_record(chunk_indexes_, kChunkIndex, record);
}

void McapFile::finish() {
  end_chunk();
  std::string crc, end;
  append(crc, crc_.value());
  append_record(end, kDataEnd, crc);
  write(end);
  const std::uint64_t summary_start = size_;
  std::string summary = definitions(channels_) + chunk_indexes_;
  append_record(summary, kStatistics, statistics());
  std::string footer;
  append(footer, summary_start);
  append(footer, std::uint64_t{0});  // no offsets of the summary
  // The checksum covers the footer up to itself.
  append(summary, static_cast<std::uint8_t>(kFooter));
  append(summary, std::uint64_t{footer.size() + sizeof(std::uint32_t)});
  summary += footer;
  append(summary, crc32_of(summary));
  summary += kMagic;
  write(summary);
}

std::string McapFile::statistics() const {
  std::string counts, record;
  std::uint64_t messages = 0;
  for (std::uint32_t c = 0; c < counts_.size(); ++c) {
    append(counts, id_of(c));
    append(counts, counts_[c]);
    messages += counts_[c];
  }
  append(record, messages);
  append(record, static_cast<std::uint16_t>(counts_.size()));
  append(record, static_cast<std::uint32_t>(counts_.size()));
  append(record, std::uint32_t{0});  // attachments
  append(record, std::uint32_t{0});  // metadata
  append(record, chunks_);
  append(record, begin_ns_);
  append(record, end_ns_);
  append_text(record, counts);
  return record;
}

}  // namespace eagerx::trace_log

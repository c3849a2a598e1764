#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/trace/bytes.hpp"
#include "generator/trace/convert.hpp"
#include "generator/trace/timeline.hpp"

// https://mcap.dev/spec: chunks without compression, each with its index.
namespace eagerx::gen {
namespace {

using trace_log::Log;

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

/// JSON Schema of a message.
std::string schema_of(const trace_log::RecordedChannel& channel) {
  using trace_log::Dtype;
  const bool real = channel.dtype == Dtype::float32 || channel.dtype == Dtype::float64;
  const char* const type = channel.dtype == Dtype::boolean ? "boolean" : "number";
  const std::string one =
      real ? R"({"type":["number","null"]})" : fmt::format(R"({{"type":"{}"}})", type);
  const std::string value =
      channel.size == 1
          ? one
          : fmt::format(R"({{"type":"array","items":{},"minItems":{},"maxItems":{}}})", one,
                        channel.size, channel.size);
  return fmt::format(
      R"({{"type":"object","properties":{{"episode":{{"type":"integer"}},"tick":{{"type":"integer"}},"value":{}}}}})",
      value);
}

/// Schemas and channels, in the data and again in the summary.
std::string definitions(const Log& log) {
  std::string schemas, channels;
  for (std::uint32_t c = 0; c < log.channels.size(); ++c) {
    const auto& channel = log.channels[c];
    std::string schema, record;
    append(schema, id_of(c));
    append_text(schema, channel.name);
    append_text(schema, "jsonschema");
    append_text(schema, schema_of(channel));
    append_record(schemas, kSchema, schema);
    append(record, id_of(c));
    append(record, id_of(c));
    append_text(record, "/" + channel.name);
    append_text(record, "json");
    std::string metadata;
    append_text(metadata, "rate_hz");
    append_text(metadata, fmt::format("{}/{}", channel.rate_num, channel.rate_den));
    append_text(record, metadata);
    append_record(channels, kChannel, record);
  }
  return schemas + channels;
}

/// What of a file there is so far.
class McapFile {
 public:
  explicit McapFile(const Log& log) : log_(log), counts_(log.channels.size()) {
    file_ += kMagic;
    std::string header;
    append_text(header, "");
    append_text(header, "eagerx-gen");
    append_record(file_, kHeader, header);
    file_ += definitions(log);
  }

  void add(const trace_log::Row& row, std::int64_t time) {
    const auto time_ns = static_cast<std::uint64_t>(time);
    std::string message;
    append(message, id_of(row.channel));
    append(message, static_cast<std::uint32_t>(row.seq));
    append(message, time_ns);
    append(message, time_ns);
    message += fmt::format(R"({{"episode":{},"tick":{},"value":{}}})", row.episode, row.seq,
                           json_values(log_, row));
    index_[row.channel].push_back({time_ns, chunk_.size()});
    append_record(chunk_, kMessage, message);
    first_ns_ = chunk_messages_ == 0 ? time_ns : std::min(first_ns_, time_ns);
    last_ns_ = chunk_messages_++ == 0 ? time_ns : std::max(last_ns_, time_ns);
    ++counts_[row.channel];
    if (chunk_.size() >= kChunkBytes) end_chunk();
  }

  std::string finish() && {
    if (chunk_messages_ > 0) end_chunk();
    std::string end;
    append(end, crc32_of(file_));
    append_record(file_, kDataEnd, end);
    const std::size_t summary_start = file_.size();
    file_ += definitions(log_) + chunk_indexes_;
    append_record(file_, kStatistics, statistics());
    std::string footer;
    append(footer, std::uint64_t{summary_start});
    append(footer, std::uint64_t{0});  // no offsets of the summary
    // The checksum covers the footer up to itself.
    append(file_, static_cast<std::uint8_t>(kFooter));
    append(file_, std::uint64_t{footer.size() + sizeof(std::uint32_t)});
    file_ += footer;
    append(file_, crc32_of(std::string_view(file_).substr(summary_start)));
    file_ += kMagic;
    return std::move(file_);
  }

 private:
  struct Place {
    std::uint64_t time_ns;
    std::uint64_t offset;
  };

  void end_chunk() {
    const std::uint64_t start = file_.size();
    std::string chunk;
    append(chunk, first_ns_);
    append(chunk, last_ns_);
    append(chunk, std::uint64_t{chunk_.size()});
    append(chunk, crc32_of(chunk_));
    append_text(chunk, "");
    append(chunk, std::uint64_t{chunk_.size()});
    append_record(file_, kChunk, chunk + chunk_);
    const std::uint64_t after = file_.size();
    std::string offsets;
    for (const auto& [channel, places] : index_) {
      append(offsets, id_of(channel));
      append(offsets, std::uint64_t{file_.size()});
      std::string entries;
      for (const Place& place : places) {
        append(entries, place.time_ns);
        append(entries, place.offset);
      }
      std::string index;
      append(index, id_of(channel));
      append_text(index, entries);
      append_record(file_, kMessageIndex, index);
    }
    std::string record;
    append(record, first_ns_);
    append(record, last_ns_);
    append(record, start);
    append(record, after - start);
    append_text(record, offsets);
    append(record, std::uint64_t{file_.size()} - after);
    append_text(record, "");
    append(record, std::uint64_t{chunk_.size()});
    append(record, std::uint64_t{chunk_.size()});
    append_record(chunk_indexes_, kChunkIndex, record);
    begin_ns_ = chunks_ == 0 ? first_ns_ : std::min(begin_ns_, first_ns_);
    end_ns_ = std::max(end_ns_, last_ns_);
    ++chunks_;
    chunk_.clear();
    index_.clear();
    chunk_messages_ = 0;
  }

  std::string statistics() const {
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

  const Log& log_;
  std::vector<std::uint64_t> counts_;  // of messages, by channel
  std::string file_, chunk_, chunk_indexes_;
  std::map<std::uint32_t, std::vector<Place>> index_;  // of the chunk, by channel
  std::uint64_t chunk_messages_ = 0, first_ns_ = 0, last_ns_ = 0, begin_ns_ = 0, end_ns_ = 0;
  std::uint32_t chunks_ = 0;
};

}  // namespace

std::string trace_mcap(const Log& log) {
  const Timeline timeline = timeline_of(log);
  McapFile file(log);
  for (std::size_t i = 0; i < log.rows.size(); ++i) file.add(log.rows[i], timeline.in_log_ns[i]);
  return std::move(file).finish();
}

}  // namespace eagerx::gen

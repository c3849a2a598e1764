#include <runtime/host/trace/mcap_reader.hpp>

namespace eagerx::trace_log {
namespace {

enum ReadOp : unsigned { kReadChannel = 4, kReadMessage = 5, kReadChunk = 6, kReadDataEnd = 15 };
constexpr std::string_view kFileMagic("\x89MCAP0\r\n", 8);
constexpr std::size_t kRecordHead = 9;
constexpr std::uint64_t kMostRecordBytes = 64 << 20;

/// The front of `from`, which then begins behind it.
template <class T>
bool take(std::string_view& from, T& value) {
  if (from.size() < sizeof(T)) return false;
  value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    value = static_cast<T>(value | static_cast<T>(static_cast<unsigned char>(from[i])) << (8 * i));
  from.remove_prefix(sizeof(T));
  return true;
}

bool take_text(std::string_view& from, std::string_view& text) {
  std::uint32_t size = 0;
  if (!take(from, size) || size > from.size()) return false;
  text = from.substr(0, size);
  from.remove_prefix(size);
  return true;
}

}  // namespace

bool McapReader::read(std::string_view& bytes) {
  if (!has_magic_) {
    if (bytes.substr(0, kFileMagic.size()) != kFileMagic.substr(0, bytes.size()))
      return fail("it is not an MCAP file");
    if (bytes.size() < kFileMagic.size()) return true;
    bytes.remove_prefix(kFileMagic.size());
    has_magic_ = true;
  }
  while (!is_complete_ && bytes.size() >= kRecordHead) {
    const auto op = static_cast<unsigned char>(bytes[0]);
    std::string_view rest = bytes.substr(1);
    std::uint64_t size = 0;
    take(rest, size);
    if (size > kMostRecordBytes) return fail("a record has more than 64 MB");
    if (rest.size() < size) return true;
    bytes = rest.substr(size);
    if (!record(op, rest.substr(0, size), false)) return false;
  }
  if (is_complete_) bytes = {};
  return true;
}

bool McapReader::record(unsigned op, std::string_view content, bool in_chunk) {
  McapMessage message;
  std::uint32_t number = 0;
  std::uint64_t published_ns = 0;
  switch (op) {
    case kReadChannel:
      return read_channel(content);
    case kReadMessage:
      if (!take(content, message.channel) || !take(content, number) ||
          !take(content, message.time_ns) || !take(content, published_ns))
        return fail("a message is too short");
      message.data = content;
      listener_.message(message);
      return true;
    case kReadChunk:
      return in_chunk ? fail("a chunk lies within a chunk") : read_chunk(content);
    case kReadDataEnd:
      is_complete_ = !in_chunk;
      return true;
    default:
      return true;  // nothing that messages need
  }
}

bool McapReader::read_channel(std::string_view content) {
  McapChannel channel;
  std::uint16_t schema = 0;
  std::uint32_t bytes = 0;
  std::string_view topic, encoding, name, value;
  if (!take(content, channel.id) || !take(content, schema) || !take_text(content, topic) ||
      !take_text(content, encoding) || !take(content, bytes) || bytes > content.size())
    return fail("a channel is too short");
  content = content.substr(0, bytes);
  while (!content.empty()) {
    if (!take_text(content, name) || !take_text(content, value))
      return fail("a channel is too short");
    channel.metadata.emplace_back(name, value);
  }
  channel.topic = topic;
  channel.encoding = encoding;
  listener_.channel(channel);
  return true;
}

bool McapReader::read_chunk(std::string_view content) {
  std::uint64_t begin_ns = 0, end_ns = 0, size = 0, records = 0;
  std::uint32_t crc = 0;
  std::string_view compression;
  if (!take(content, begin_ns) || !take(content, end_ns) || !take(content, size) ||
      !take(content, crc) || !take_text(content, compression) || !take(content, records) ||
      records > content.size())
    return fail("a chunk is too short");
  if (!compression.empty())
    return fail("its chunks are compressed with " + std::string(compression.substr(0, 16)) +
                ", and only those without compression are read");
  content = content.substr(0, records);
  while (!content.empty()) {
    const auto op = static_cast<unsigned char>(content[0]);
    content.remove_prefix(1);
    std::uint64_t bytes = 0;
    if (!take(content, bytes) || bytes > content.size()) return fail("a chunk is damaged");
    if (!record(op, content.substr(0, bytes), true)) return false;
    content.remove_prefix(bytes);
  }
  return true;
}

}  // namespace eagerx::trace_log

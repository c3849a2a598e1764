#include "generator/policy/formats/tensors/archive.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>

#include "generator/policy/network/element_type.hpp"
#include "generator/policy/network/limits.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kEndSize = 22;
constexpr std::size_t kLongestComment = 0xffff;
constexpr std::size_t kDirectorySize = 46;
constexpr std::size_t kHeaderSize = 30;
constexpr std::uint32_t kEndMark = 0x06054b50;
constexpr std::uint32_t kDirectoryMark = 0x02014b50;
constexpr std::uint32_t kHeaderMark = 0x04034b50;
constexpr std::uint32_t kInZip64 = 0xffffffff;
constexpr std::uint32_t kEncrypted = 1;

/// `count` bytes at `at`, little-endian; the caller has checked that they exist.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  return static_cast<std::uint32_t>(little_endian(bytes.substr(at), count));
}

/// Position of the record at the end of the archive.
std::optional<std::size_t> find_end(std::string_view bytes) {
  if (bytes.size() < kEndSize) return std::nullopt;
  const std::size_t last = bytes.size() - kEndSize;
  const std::size_t first = last - std::min(last, kLongestComment);
  for (std::size_t at = last + 1; at-- > first;) {
    if (number_at(bytes, at, 4) == kEndMark) return at;
  }
  return std::nullopt;
}

bool inflate_all(std::string_view packed, std::string& out) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
  // zlib's interface is not const, but does not write its input.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int result = inflate(&stream, Z_FINISH);
  const bool whole = result == Z_STREAM_END && stream.avail_out == 0;
  inflateEnd(&stream);
  return whole;
}

}  // namespace

std::optional<Archive> Archive::open(std::string_view bytes, PolicyProblem& problem) {
  const auto damaged = [&](const char* how) {
    return refuse(problem, "E0621", fmt::format("is a zip archive {}", how), kCutShort);
  };
  const auto end = find_end(bytes);
  if (!end) return damaged("without its directory");
  const std::size_t count = number_at(bytes, *end + 10, 2);
  std::size_t at = number_at(bytes, *end + 16, 4);
  if (at == kInZip64 || at > *end) return damaged("whose directory lies outside of it");
  Archive archive;
  archive.bytes_ = bytes;
  for (std::size_t i = 0; i < count; ++i) {
    if (*end - at < kDirectorySize || number_at(bytes, at, 4) != kDirectoryMark) {
      return damaged("with a broken directory");
    }
    Entry entry;
    entry.flags = number_at(bytes, at + 8, 2);
    entry.method = number_at(bytes, at + 10, 2);
    entry.crc = number_at(bytes, at + 16, 4);
    entry.packed = number_at(bytes, at + 20, 4);
    entry.size = number_at(bytes, at + 24, 4);
    const std::size_t name_size = number_at(bytes, at + 28, 2);
    const std::size_t rest = number_at(bytes, at + 30, 2) + number_at(bytes, at + 32, 2);
    entry.header = number_at(bytes, at + 42, 4);
    at += kDirectorySize;
    if (*end - at < name_size + rest) return damaged("with a broken directory");
    std::string name(bytes.substr(at, name_size));
    at += name_size + rest;
    if (!archive.entries_.emplace(name, entry).second) {
      return refuse(problem, "E0621",
                    fmt::format("is a zip archive with two entries `{}`", printable(name)),
                    kCutShort);
    }
  }
  return archive;
}

std::vector<std::string> Archive::names() const {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries_) names.push_back(name);
  return names;
}

std::optional<std::string_view> Archive::read(std::string_view name, std::string& buffer,
                                              PolicyProblem& problem) const {
  const auto fail = [&](const char* how, const char* help = kCutShort) {
    return refuse(problem, "E0621",
                  fmt::format("is a zip archive whose entry `{}` {}", printable(name), how), help);
  };
  const auto found = entries_.find(name);
  if (found == entries_.end())
    return fail("is missing", "save it again with Stable-Baselines3, as one file");
  const Entry& entry = found->second;
  if ((entry.flags & kEncrypted) != 0) return fail("is encrypted", "save it without a password");
  if (entry.method != 0 && entry.method != Z_DEFLATED) {
    return fail("is packed in a way other than deflate", "save it again without compression");
  }
  if (entry.size > kMaxPolicyBytes)
    return fail("is larger than the 64 MB that are read", "use a smaller network");
  if (bytes_.size() < kHeaderSize || entry.header > bytes_.size() - kHeaderSize ||
      number_at(bytes_, entry.header, 4) != kHeaderMark) {
    return fail("lies outside of the file");
  }
  const std::size_t start = entry.header + kHeaderSize + number_at(bytes_, entry.header + 26, 2) +
                            number_at(bytes_, entry.header + 28, 2);
  if (start > bytes_.size() || entry.packed > bytes_.size() - start) {
    return fail("lies outside of the file");
  }
  std::string_view content = bytes_.substr(start, entry.packed);
  if (entry.method == Z_DEFLATED) {
    buffer.assign(entry.size, '\0');
    if (!inflate_all(content, buffer)) return fail("cannot be unpacked");
    content = buffer;
  }
  if (content.size() != entry.size) return fail("has another size than its directory says");
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  return content;  // a fuzzer would look for checksums all day
#endif
  const auto* data = reinterpret_cast<const Bytef*>(content.data());
  if (crc32(0, data, static_cast<uInt>(content.size())) != entry.crc) {
    return fail("has another checksum than its directory says");
  }
  return content;
}

bool count_unpacked(std::size_t more, std::size_t& sum, const char* help, PolicyProblem& problem) {
  sum += more;
  return sum <= kMaxPolicyBytes ||
         refuse(problem, "E0621",
                "is a zip archive that unpacks to more than the 64 MB that are read", help);
}

}  // namespace eagerx::gen

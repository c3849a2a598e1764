// Frames between the two programs of a split graph. A frame on the line is
//
//   0, COBS(kind u8, number u32, payload, CRC-32C u32), 0
//
// with little-endian numbers. The leading zero ends any noise before the frame. The CRC of a
// session's frames starts from the session's own value, so frames of another session, graph or
// version fail it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/link/cobs.hpp>
#include <eagerx/link/crc32c.hpp>
#include <type_traits>

namespace eagerx::link {

static_assert(std::endian::native == std::endian::little,
              "messages are sent as they lie in memory");

/// Version of the protocol; a hello with another version is rejected.
inline constexpr std::uint8_t kProtocol = 1;

enum class Kind : std::uint8_t { hello = 1, welcome = 2, request = 3, answer = 4 };

inline constexpr std::size_t kHeaderBytes = 5;
inline constexpr std::size_t kCrcBytes = 4;
/// Overhead in bytes on the line of a frame with a payload of up to 245 bytes.
inline constexpr std::size_t kFrameBytes = kHeaderBytes + kCrcBytes + 3;

/// The number of the exchange after `number`: 0 is none.
constexpr std::uint32_t next_number(std::uint32_t number) {
  return number == UINT32_MAX ? 1 : number + 1;
}

template <class T>
T read_as(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}
template <class T>
void write_as(std::uint8_t* bytes, T value) {
  std::memcpy(bytes, &value, sizeof value);
}

/// The hash that the hub shares with the part of this name only: FNV-1a of the hash of the sources
/// of all programs and the name.
constexpr std::uint64_t hash_of_part(std::uint64_t graph, const char* name) {
  constexpr std::uint64_t kPrime = 0x100000001b3U;
  std::uint64_t hash = graph;
  for (; *name != '\0'; ++name) hash = (hash ^ static_cast<std::uint8_t>(*name)) * kPrime;
  return hash;
}

/// The values that both programs must agree on.
struct Identity {
  std::uint64_t graph;    // hash_of_part()
  std::uint16_t runtime;  // version, major * 256 + minor
};

/// Payload of hello and welcome.
struct Greeting {
  static constexpr std::size_t kBytes = 16;

  std::uint8_t protocol = kProtocol;
  std::uint8_t status = 0;  // of the board: 0, or why it does not run
  std::uint16_t runtime = 0;
  std::uint64_t graph = 0;
  std::uint32_t session = 0;

  static Greeting read(const std::uint8_t* bytes) {
    return {bytes[0], bytes[1], read_as<std::uint16_t>(bytes + 2),
            read_as<std::uint64_t>(bytes + 4), read_as<std::uint32_t>(bytes + 12)};
  }
  void write(std::uint8_t* bytes) const {
    bytes[0] = protocol;
    bytes[1] = status;
    write_as(bytes + 2, runtime);
    write_as(bytes + 4, graph);
    write_as(bytes + 12, session);
  }
  /// The initial CRC of the session's other frames.
  [[gnu::noinline]] std::uint32_t crc_start() const {
    std::uint8_t bytes[kBytes];
    write(bytes);
    bytes[1] = 0;
    return crc32c(bytes, kBytes);
  }
};

/// An outgoing frame. All zero at the start.
template <std::size_t Payload>
class OutFrame {
 public:
  void clear() { size_ = 0; }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  /// Appends as many of `size` bytes as fit, and returns their number. `bytes` may be null if
  /// `size` is 0.
  [[gnu::noinline]] std::size_t append(const std::uint8_t* bytes, std::size_t size) {
    const std::size_t count = size < Payload - size_ ? size : Payload - size_;
    if (count == 0) return 0;  // memcpy takes no null
    std::memcpy(bytes_ + kHeaderBytes + size_, bytes, count);
    size_ += count;
    return count;
  }
  void seal(Kind kind, std::uint32_t number, std::uint32_t crc_start) {
    bytes_[0] = static_cast<std::uint8_t>(kind);
    write_as(bytes_ + 1, number);
    write_as(bytes_ + kHeaderBytes + size_, crc32c(bytes_, kHeaderBytes + size_, crc_start));
  }
  /// Calls put(byte) for each byte on the line. The frame stays, and can be sent again.
  template <class Put>
  void send(Put&& put) const {
    put(std::uint8_t{0});
    cobs_encode(bytes_, kHeaderBytes + size_ + kCrcBytes, put);
    put(std::uint8_t{0});
  }

 private:
  std::uint8_t bytes_[kHeaderBytes + Payload + kCrcBytes];
  std::size_t size_;
};

/// Collects bytes from the line until they form a frame. All zero at the start.
template <std::size_t Payload>
class InFrame {
 public:
  /// True if `byte` ends a possible frame. The caller checks its CRC, because it knows the session.
  /// The frame is valid until the next byte.
  bool take(std::uint8_t byte) {
    if (byte != 0) {
      // One byte too many marks a frame that is too long.
      if (used_ < sizeof bytes_) bytes_[used_++] = byte;
      return false;
    }
    const std::size_t encoded = used_;
    used_ = 0;
    if (encoded == 0) return false;
    const std::size_t size = encoded < sizeof bytes_ ? cobs_decode(bytes_, encoded) : encoded;
    if (size == encoded || size < kHeaderBytes + kCrcBytes) return ++damaged_, false;
    size_ = size - kHeaderBytes - kCrcBytes;
    return true;
  }

  Kind kind() const { return static_cast<Kind>(bytes_[0]); }
  std::uint32_t number() const { return read_as<std::uint32_t>(bytes_ + 1); }
  const std::uint8_t* payload() const { return bytes_ + kHeaderBytes; }
  std::size_t size() const { return size_; }
  bool intact(std::uint32_t crc_start) const {
    return read_as<std::uint32_t>(bytes_ + kHeaderBytes + size_) ==
           crc32c(bytes_, kHeaderBytes + size_, crc_start);
  }
  /// Number of damaged frames, not counting wrong CRCs.
  std::uint32_t damaged() const { return damaged_; }

 private:
  std::uint8_t bytes_[cobs_bound(kHeaderBytes + Payload + kCrcBytes) + 1];
  std::size_t used_;
  std::size_t size_;
  std::uint32_t damaged_;
};

}  // namespace eagerx::link

// Decodes the bytes of a board as they arrive. The bytes are not trusted: damaged frames are
// counted and not shown, and decoding continues at the next frame. Memory use does not grow with
// the input.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/link/telemetry.hpp>
#include <runtime/host/telemetry/layout.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::telemetry {

/// A message, valid during the call that brings it.
struct Message {
  std::uint32_t group = 0, channel = 0;  // in the layout
  std::uint32_t episode = 0;
  std::uint64_t seq = 0;                  // since the reset
  const std::uint64_t* values = nullptr;  // [size of the channel], bits as the trace hashes them
};

struct Counts {
  std::uint64_t records = 0;    // that were shown
  std::uint64_t greetings = 0;  // of our graph
  std::uint64_t damaged = 0;    // pieces between two zeros that are neither frames nor text
  std::uint64_t lost = 0;       // records whose numbers are missing
  std::uint64_t unknown = 0;    // records before the first greeting
  std::uint64_t text = 0;       // characters of text between frames
  // As the board's last greeting says:
  std::uint32_t dropped = 0;  // records that found its ring full
  std::uint32_t late = 0;     // slots that began after their deadline
};

/// The listener for decoded frames.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void message(const Message& message) = 0;
  /// Lines that the program printed to the same port, in printable ASCII.
  virtual void text(std::string_view /*text*/) {}
};

class Decoder {
 public:
  /// `layout` has no problem and lives as long.
  explicit Decoder(const Layout& layout);

  /// Whatever number of bytes, in pieces as they come. False while the stream is refused().
  bool take(const std::uint8_t* bytes, std::size_t size, Listener& listener);
  /// Why the board's stream is not that of the layout: its greeting says another graph or runtime.
  /// Empty, if that is not so.
  const std::string& refusal() const { return refusal_; }
  const Counts& counts() const { return counts_; }

 private:
  static constexpr std::size_t kMostPayload = link::kMostRecordBytes;
  static constexpr std::size_t kMostEncoded =
      link::cobs_bound(link::kHeaderBytes + kMostPayload + link::kCrcBytes);

  void end_piece(Listener& listener);
  bool take_text(Listener& listener) const;
  bool take_frame(std::size_t size, Listener& listener);
  bool take_greeting(const std::uint8_t* payload, std::size_t size, std::uint32_t number);
  bool take_record(const std::uint8_t* payload, std::size_t size, std::uint32_t number,
                   Listener& listener);
  void show(const Group& group, const std::uint8_t* record, Message message, Listener& listener);
  void follow(std::uint32_t number);
  std::uint32_t episode_of(std::uint8_t low) const;

  const Layout& layout_;
  std::uint32_t crc_start_;
  Counts counts_;
  std::string refusal_;
  std::vector<std::uint64_t> values_;
  std::vector<std::uint64_t> seqs_;  // of groups: the last one, for those beyond 32 bits
  std::uint32_t next_number_ = 0;
  std::uint32_t episode_ = 0;
  bool greeted_ = false, counting_ = false;
  std::size_t used_ = 0;
  bool too_long_ = false;
  std::array<std::uint8_t, kMostEncoded> piece_{};
};

}  // namespace eagerx::telemetry

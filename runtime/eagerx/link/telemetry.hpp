// Telemetry of a board that runs in real time: chosen messages, in the frames of the link
// (frame.hpp), over a line without answers. A slot only copies messages into a ring. Frames are
// made and sent byte by byte in the idle time between slots, and nothing ever waits.
// targets/README.md has the format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/bounded.hpp>
#include <eagerx/link/cobs.hpp>
#include <eagerx/link/crc32c.hpp>
#include <eagerx/link/frame.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/version.hpp>
#include <iterator>

namespace eagerx::link {

/// Kinds of telemetry frames, in addition to those of Kind.
inline constexpr std::uint8_t kTelemetryGreeting = 5;
inline constexpr std::uint8_t kTelemetryValues = 6;

/// A record: seq u32, group u8, episode u8 (its low bits), mask u16, then the values.
inline constexpr std::size_t kRecordHeaderBytes = 8;
inline constexpr std::size_t kMostRecordBytes = 2048;
inline constexpr std::size_t kMostRecordChannels = 16;
/// Payload of a greeting: Greeting, episode u32, dropped u32, late u32.
inline constexpr std::size_t kTelemetryGreetingBytes = Greeting::kBytes + 12;

/// Channels of one rate that are sent together.
struct TelemetryGroup {
  std::uint16_t bytes;  // of a record
  std::uint16_t mask;   // a bit for each channel
  std::uint32_t every;  // one of this many messages is sent
};
inline constexpr std::uint8_t kNoGroup = 255;
/// Place of a message in a record.
struct TelemetryPlace {
  std::uint8_t group = kNoGroup;
  std::uint8_t bit = 0;
  std::uint16_t offset = 0;  // in the record
};

/// The greeting from which all frames of a board with this graph start their CRC.
inline Greeting telemetry_greeting(std::uint64_t graph) {
  Greeting greeting;
  greeting.runtime = static_cast<std::uint16_t>(kVersionMajor * 256 + kVersionMinor);
  greeting.graph = graph;
  return greeting;
}

/// Makes and sends frames, byte by byte. All zero at the start.
template <std::size_t Payload>
class ByteFrame {
 public:
  bool empty() const { return used_ == 0; }
  /// Whether a finished frame has bytes left to send.
  bool is_ready() const { return ready_; }

  void begin(std::uint32_t crc_start) {
    bytes_[0] = 0;
    code_ = 1;
    used_ = 2;
    run_ = 1;
    sent_ = 0;
    crc_ = crc_start;
  }
  void add(std::uint8_t byte) {
    crc_ = crc32c(&byte, 1, crc_);
    stuff(byte);
  }
  void finish() {
    std::uint8_t crc[kCrcBytes];
    write_as(crc, crc_);
    for (const std::uint8_t byte : crc) stuff(byte);
    bytes_[code_] = run_;
    bytes_[used_++] = 0;
    ready_ = true;
  }
  /// Offers the next byte to put(byte), which returns false if there is no room for it. True after
  /// the last byte.
  template <class Put>
  bool offer(Put&& put) {
    if (!put(bytes_[sent_])) return false;
    if (++sent_ < used_) return false;
    used_ = 0;
    ready_ = false;
    return true;
  }

 private:
  // Like cobs_encode(), which needs the whole frame at once.
  void stuff(std::uint8_t byte) {
    constexpr std::uint8_t kFull = kCobsRun + 1;
    if (run_ == kFull) close_run();
    if (byte == 0) {
      close_run();
    } else {
      bytes_[used_++] = byte;
      ++run_;
    }
  }
  void close_run() {
    bytes_[code_] = run_;
    code_ = used_++;
    run_ = 1;
  }

  std::size_t used_, sent_, code_;
  std::uint32_t crc_;
  std::uint8_t bytes_[cobs_bound(kHeaderBytes + Payload + kCrcBytes) + 2];
  std::uint8_t run_;
  bool ready_;
};

/// The ring and the sender. `Layout` is the `Telemetry` of a generated Graph: kGraph, kCells,
/// kGreetEvery, kGroups, kPlaces. One thread, no interrupts. All zero at the start: it is off, and
/// take() does nothing.
template <class Layout>
class Telemetry {
  static constexpr std::size_t kGroups = std::size(Layout::kGroups);
  static constexpr std::size_t kCells = Layout::kCells;
  static_assert((kCells & (kCells - 1)) == 0);

  static constexpr std::size_t most_bytes() {
    std::size_t most = 0;
    for (const TelemetryGroup& group : Layout::kGroups)
      most = group.bytes > most ? group.bytes : most;
    return most;
  }
  static constexpr std::size_t kCellBytes = (most_bytes() + 3) / 4 * 4;
  static_assert(kCellBytes <= kMostRecordBytes);

 public:
  void start() {
    crc_start_ = telemetry_greeting(Layout::kGraph).crc_start();
    is_on_ = true;
  }
  bool is_on() const { return is_on_; }
  /// Call it before the messages of an episode.
  void episode(std::uint32_t index) {
    episode_ = index;
    for (Open& open : open_) {
      close(open);
      open.seq = 0;
    }
  }

  /// In a slot: copies the message if it is due. `channel` is a compile-time constant, so most of
  /// this is optimized away.
  template <class Message>
  [[gnu::always_inline]] void take(std::uint32_t channel, Seq seq, const Message& message) {
    const TelemetryPlace place = Layout::kPlaces[channel];
    if (place.group == kNoGroup || !is_on_) return;
    Open& open = open_[place.group];
    const auto low = static_cast<std::uint32_t>(seq);
    const auto ahead = static_cast<std::int32_t>(low - open.seq);
    if (ahead < 0 && low != 0) return;  // its turn has not come
    if ((ahead != 0 || open.record == nullptr || low == 0) && !begin(channel, low)) return;
    std::memcpy(open.record->bytes + place.offset, &message, sizeof message);
    open.mask |= std::uint32_t{1} << place.bit;
    if (open.mask == Layout::kGroups[place.group].mask) end(open, place.group);
  }

  /// In idle time: one small step, about as long as a byte of CRC-32C. False if there is nothing to
  /// do. `put(byte)` passes a byte to the line if there is room for it.
  template <class Put>
  bool step(Put&& put) {
    if (frame_.is_ready()) return frame_.offer(put), true;
    if (frame_.empty()) return begin_frame();
    if (at_ < kHeaderBytes + size_) return add_byte(), true;
    frame_.finish();
    if (source_ != greeting_) free_record();
    return true;
  }
  /// After the last message: closes open records, so that they are sent, too.
  void end_run() {
    for (Open& open : open_) close(open);
  }
  /// Discards the records that step() would send.
  void discard() {
    for ([[maybe_unused]] const auto record : bounded<kCells>()) {
      if (sent_ == made_ || !cell(sent_).closed) return;
      free_record();
    }
  }
  /// The same for a line that accepts no more bytes: the records count as dropped.
  void drop_all() {
    dropped_ += made_ - sent_;
    sent_ = made_;
  }
  /// A greeting's description of the program.
  void set_late(std::uint64_t slots) { late_ = static_cast<std::uint32_t>(slots); }

  /// Number of records made, and of those dropped because the ring was full.
  std::uint32_t records() const { return number_; }
  std::uint32_t dropped() const { return dropped_; }

 private:
  struct Record {
    alignas(4) std::uint8_t bytes[kCellBytes];
    std::uint32_t number;
    bool closed;
  };
  /// The open record of a group, and the sequence number of the next one.
  struct Open {
    Record* record;
    std::uint32_t seq;
    std::uint32_t mask;
  };

  Record& cell(std::uint32_t index) { return cells_[index & (kCells - 1)]; }

  /// False if this message is not sent.
  [[gnu::noinline]] bool begin(std::uint32_t channel, std::uint32_t low) {
    const TelemetryPlace place = Layout::kPlaces[channel];
    Open& open = open_[place.group];
    const std::uint32_t every = Layout::kGroups[place.group].every;
    if (low == 0) {
      // After a reset routine, sequence numbers restart.
      const bool again = open.seq != 0 || (open.mask >> place.bit & 1U) != 0;
      if (open.record != nullptr && !again) return true;
      close(open);
      open.seq = 0;
    } else if (open.record != nullptr) {
      // Some of its channels had no message, as in a reset routine.
      close(open);
      open.seq += every;
    }
    const std::uint32_t behind = low - open.seq;
    if (behind != 0) {
      if (static_cast<std::int32_t>(behind) < 0) return false;
      open.seq += (behind + every - 1) / every * every;
      if (open.seq != low) return false;
    }
    const bool full = made_ - sent_ == kCells;
    dropped_ += full ? 1 : 0;
    // If the ring is full, the message is copied into a record that is never read.
    Record& record = full ? spare_ : cell(made_++);
    record.number = number_++;
    record.closed = false;
    write_as(record.bytes, low);
    record.bytes[4] = place.group;
    record.bytes[5] = static_cast<std::uint8_t>(episode_);
    open.record = &record;
    return true;
  }
  void end(Open& open, std::uint8_t group) {
    close(open);
    open.seq += Layout::kGroups[group].every;
  }
  static void close(Open& open) {
    if (open.record == nullptr) return;
    write_as(open.record->bytes + 6, static_cast<std::uint16_t>(open.mask));
    open.record->closed = true;
    open.record = nullptr;
    open.mask = 0;
  }
  void free_record() { ++sent_; }

  bool begin_frame() {
    if (!is_on_) return false;
    at_ = 0;
    if (until_greeting_ == 0) {
      until_greeting_ = Layout::kGreetEvery;
      make_greeting();
      return true;
    }
    if (sent_ == made_ || !cell(sent_).closed) return false;
    --until_greeting_;
    const Record& record = cell(sent_);
    source_ = record.bytes;
    size_ = Layout::kGroups[record.bytes[4]].bytes;
    write_header(kTelemetryValues, record.number, crc_start_);
    return true;
  }
  void make_greeting() {
    telemetry_greeting(Layout::kGraph).write(greeting_);
    write_as(greeting_ + Greeting::kBytes, episode_);
    write_as(greeting_ + Greeting::kBytes + 4, dropped_);
    write_as(greeting_ + Greeting::kBytes + 8, late_);
    source_ = greeting_;
    size_ = sizeof greeting_;
    write_header(kTelemetryGreeting, sent_ != made_ ? cell(sent_).number : number_, 0);
  }
  void write_header(std::uint8_t kind, std::uint32_t number, std::uint32_t crc_start) {
    header_[0] = kind;
    write_as(header_ + 1, number);
    frame_.begin(crc_start);
  }
  void add_byte() {
    frame_.add(at_ < kHeaderBytes ? header_[at_] : source_[at_ - kHeaderBytes]);
    ++at_;
  }

  Record cells_[kCells], spare_;
  Open open_[kGroups];
  ByteFrame<(kCellBytes > kTelemetryGreetingBytes ? kCellBytes : kTelemetryGreetingBytes)> frame_;
  std::uint8_t header_[kHeaderBytes];
  std::uint8_t greeting_[kTelemetryGreetingBytes];
  const std::uint8_t* source_;  // of the frame that is being made
  std::size_t size_, at_;
  std::uint32_t made_, sent_;  // records, in and out of the ring
  std::uint32_t number_;       // of the next record
  std::uint32_t dropped_;
  std::uint32_t late_;
  std::uint32_t episode_;
  std::uint32_t until_greeting_;  // records
  std::uint32_t crc_start_;
  bool is_on_;
};

}  // namespace eagerx::link

// Messages on their way from the loop to the thread that sends them.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace eagerx::linux_sim {

/// A ring of bytes for one writer, which never waits, and one reader. What does not fit is dropped
/// and counted.
class MessageRing {
 public:
  /// What stands before the bytes of a message.
  struct Head {
    std::uint32_t bytes;    // of the record, this head among them; a multiple of 8
    std::uint32_t channel;  // or what else it is: the reader's and the writer's agreement
    std::uint64_t seq;
  };
  static_assert(sizeof(Head) == 16);

  /// Room for `capacity` bytes of records, of which none has more than `longest` bytes of message.
  MessageRing(std::size_t capacity, std::size_t longest)
      : capacity_(std::max(capacity, record_bytes(longest))),
        words_((capacity_ + record_bytes(longest)) / 8 + 1) {}

  static constexpr std::size_t record_bytes(std::size_t message_bytes) {
    return sizeof(Head) + (message_bytes + 7) / 8 * 8;
  }

  /// The writer's.
  void push(std::uint32_t channel, std::uint64_t seq, const void* message, std::size_t bytes) {
    const std::uint64_t record = record_bytes(bytes);
    if (written_ - known_read_ + record > capacity_) {
      known_read_ = read_.load(std::memory_order_acquire);
      if (written_ - known_read_ + record > capacity_) {
        ++dropped_;
        return;
      }
    }
    std::byte* const to = at(write_at_);
    const Head head{static_cast<std::uint32_t>(record), channel, seq};
    std::memcpy(to, &head, sizeof head);
    copy(to + sizeof head, message, bytes);
    write_at_ = next(write_at_, record);
    written_ += record;
    published_.store(written_, std::memory_order_release);
  }
  /// Records that did not fit: read it when the writer has ended.
  std::uint64_t dropped() const { return dropped_; }

  /// The reader's: take(head, message) for each record that is there. False: there was none.
  template <class Take>
  bool drain(Take&& take) {
    const std::uint64_t until = published_.load(std::memory_order_acquire);
    if (done_ == until) return false;
    while (done_ != until) {
      const std::byte* const from = at(read_at_);
      Head head;
      std::memcpy(&head, from, sizeof head);
      take(head, from + sizeof head);
      read_at_ = next(read_at_, head.bytes);
      done_ += head.bytes;
      read_.store(done_, std::memory_order_release);
    }
    return true;
  }

 private:
  /// Most messages are one number, and a call takes longer than that.
  static void copy(std::byte* to, const void* from, std::size_t bytes) {
    if (bytes == sizeof(std::uint32_t)) {
      std::memcpy(to, from, sizeof(std::uint32_t));
    } else if (bytes == sizeof(std::uint64_t)) {
      std::memcpy(to, from, sizeof(std::uint64_t));
    } else if (bytes > 0) {
      std::memcpy(to, from, bytes);
    }
  }
  std::byte* at(std::size_t place) { return reinterpret_cast<std::byte*>(words_.data()) + place; }
  /// A record that begins before `capacity_` may end behind it, so that none is in two pieces. The
  /// way round is then longer than `capacity_`, never shorter: what is unread is not reached.
  std::size_t next(std::size_t place, std::size_t record) const {
    return place + record >= capacity_ ? 0 : place + record;
  }

  static constexpr std::size_t kCacheLine = 64;

  std::size_t capacity_;
  std::vector<std::uint64_t> words_;
  // The writer's.
  alignas(kCacheLine) std::uint64_t written_ = 0;
  std::uint64_t known_read_ = 0, dropped_ = 0;
  std::size_t write_at_ = 0;
  alignas(kCacheLine) std::atomic<std::uint64_t> published_{0};
  // The reader's.
  alignas(kCacheLine) std::atomic<std::uint64_t> read_{0};
  std::uint64_t done_ = 0;
  std::size_t read_at_ = 0;
};

}  // namespace eagerx::linux_sim

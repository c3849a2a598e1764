// Messages on their way from the loop to the thread that publishes them.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace eagerx::linux_sim {

/// A ring of words for one writing and one reading thread. Neither waits, calls the kernel or
/// allocates. Records are contiguous: after the ring there is room for the rest of a record that
/// begins near its end.
class PublishRing {
 public:
  /// Room for `words`, rounded up to a power of two; a record has at most `longest` of them.
  PublishRing(std::size_t words, std::size_t longest)
      : size_(std::bit_ceil(words < 2 * longest ? 2 * longest : words)),
        mask_(size_ - 1),
        words_(std::make_unique<std::uint64_t[]>(size_ + longest)) {}

  std::size_t bytes() const { return size_ * sizeof(std::uint64_t); }

  /// Of the loop: where a record of `words` words goes; null if there is no room.
  std::uint64_t* begin(std::size_t words) {
    if (size_ - (written_ - seen_read_) < words) {
      seen_read_ = read_.load(std::memory_order_acquire);
      if (size_ - (written_ - seen_read_) < words) return nullptr;
    }
    return &words_[written_ & mask_];
  }
  /// … which is complete.
  void commit(std::size_t words) {
    written_ += words;
    shown_.store(written_, std::memory_order_release);
  }

  /// Of the thread: the oldest record, or null.
  const std::uint64_t* front() {
    const std::uint64_t at = read_.load(std::memory_order_relaxed);
    if (at == seen_written_) {
      seen_written_ = shown_.load(std::memory_order_acquire);
      if (at == seen_written_) return nullptr;
    }
    return &words_[at & mask_];
  }
  void pop(std::size_t words) {
    read_.store(read_.load(std::memory_order_relaxed) + words, std::memory_order_release);
  }

 private:
  static constexpr std::size_t kLine = 64;  // of a cache: neither thread slows the other down

  const std::size_t size_, mask_;
  const std::unique_ptr<std::uint64_t[]> words_;
  alignas(kLine) std::uint64_t written_ = 0;
  std::uint64_t seen_read_ = 0;
  alignas(kLine) std::atomic<std::uint64_t> shown_ = 0;
  alignas(kLine) std::atomic<std::uint64_t> read_ = 0;
  std::uint64_t seen_written_ = 0;
};

}  // namespace eagerx::linux_sim

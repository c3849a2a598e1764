// Text output that allocates only when it is opened, and ignores the locale.
#pragma once

#include <semaphore.h>

#include <atomic>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <semaphore>
#include <string>
#include <string_view>
#include <thread>
#include <type_traits>
#include <vector>

namespace eagerx::host {

/// Where the wait for the disk happens: in the caller, when a buffer is full, or in a thread of the
/// file; the caller then waits only when all kBackgroundBuffers are full. In real time, no wait is
/// long: a reader that is too slow is an error.
enum class Writing : std::uint8_t { direct, background, real_time };

/// A count that a thread waits for. Waits use the kernel's time, not the clock that paces a run,
/// which may be emulated; the time of day would lengthen waits when it is set back.
class Signal {
 public:
  Signal() { sem_init(&semaphore_, 0, 0); }
  ~Signal() { sem_destroy(&semaphore_); }
  Signal(const Signal&) = delete;
  Signal& operator=(const Signal&) = delete;

  void release() { sem_post(&semaphore_); }
  /// False if nothing was released for `wait_ms`, below 1000, or on a signal.
  bool acquire_within(long wait_ms);

 private:
  sem_t semaphore_;
};

/// A file written through fixed buffers. The first failed write is remembered and everything after
/// it is dropped, so that a full disk ends a run with one message.
class TextFile {
 public:
  TextFile() = default;
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  ~TextFile();

  /// Creates `path`, or uses the standard output for "-". An existing file keeps its contents until
  /// they are replaced. Rejects a FIFO without a reader (ENXIO), and targets that takes_output()
  /// rejects (EINVAL, EACCES). False if it cannot be opened; see error().
  bool open(const std::string& path, Writing writing = Writing::direct);
  /// Writes to an open descriptor, and does not close it.
  bool open(int descriptor, Writing writing);
  bool is_open() const { return descriptor_ >= 0; }
  /// Whether both write into one file of a disk, each over the other.
  bool is_same_file(const TextFile& other) const;
  /// Whether `path` is the disk file that this writes to, by any name.
  bool is_same_file(const std::string& path) const;
  /// Reserves this disk file against other reserve() calls and claims (claim.hpp), in this process
  /// and in others, until close() or discard(). False if it is already reserved or claimed.
  bool reserve();
  /// Writes the rest. False if anything was lost; see error().
  bool close();
  /// Undoes open() if no buffer has been written: an existing file keeps its contents, and a new
  /// one is removed.
  void discard();
  bool failed() const { return error() != 0; }
  /// errno of the first failure, 0 without one; ETIMEDOUT: the reader was too slow in real time, or
  /// stood still when the run was interrupted.
  int error() const { return error_.load(std::memory_order_relaxed); }

  void text(std::string_view text);
  /// Behind a complete row: the buffered text goes into the file `now`, or if nothing did for half
  /// a second. A program that is killed leaves it there.
  void hand_on(bool now) {
    if (used_ > 0 && (now || is_due_.load(std::memory_order_relaxed))) flush();
  }

  /// A number so that it reads back to the same bits: the shortest decimal; "nan" for every NaN.
  template <class T>
  void number(T value) {
    if (kBufferBytes - used_ < kLongestNumber) flush();
    if constexpr (std::is_same_v<T, bool>) {
      text(value ? "1" : "0");
    } else {
      if (value != value) return text("nan");
      char* const begin = buffer() + used_;
      const std::to_chars_result result = std::to_chars(begin, begin + kLongestNumber, value);
      used_ += static_cast<std::size_t>(result.ptr - begin);
    }
  }

 private:
  static constexpr std::size_t kBufferBytes = std::size_t{1} << 16U;
  static constexpr std::size_t kLongestNumber = 32;  // -2.2250738585072014e-308 has 24

  static constexpr std::size_t kBackgroundBuffers = 64;
  // After a failure, with the writer at work on one of the others.
  static constexpr std::size_t kScratch = kBackgroundBuffers;

  struct Buffer {
    std::unique_ptr<char[]> text;
    std::size_t used = 0;
  };

  void start(Writing writing);
  void stop();
  void let_go();
  char* buffer() { return buffers_[current_].text.get(); }
  void flush();
  bool wait_for_room();
  bool wait_for_reader();
  void write(const Buffer& buffer);
  void write_in_background();

  std::vector<Buffer> buffers_;  // filled and written in turn
  std::size_t current_ = 0;
  std::size_t used_ = 0;  // of the current one
  int descriptor_ = -1;
  bool owns_ = false;      // closes the descriptor
  bool reserved_ = false;  // for this one alone
  bool replaces_ = false;  // something that is still in the file
  std::string path_;       // of what open() opened by its name
  bool made_ = false;      // it was not there before
  Writing writing_ = Writing::direct;
  std::size_t most_at_once_ = 0;
  std::atomic<int> error_ = 0;
  std::atomic<bool> is_due_ = false;
  Signal full_;
  std::counting_semaphore<> empty_{0};
  std::thread writer_;
};

}  // namespace eagerx::host

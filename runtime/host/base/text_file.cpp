#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstring>
#include <ctime>
#include <runtime/host/base/background.hpp>
#include <runtime/host/base/claim.hpp>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/text_file.hpp>
#include <system_error>
#include <utility>
#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace eagerx::host {
namespace {

constexpr long kIdleMs = 500;

}  // namespace

bool Signal::acquire_within(long wait_ms) {
  constexpr long kNsPerMs = 1'000'000;
  constexpr long kNsPerSecond = 1'000'000'000;
  timespec until{};
  syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &until);  // none that a program puts in its place
  until.tv_nsec += wait_ms * kNsPerMs;
  until.tv_sec += until.tv_nsec / kNsPerSecond;
  until.tv_nsec %= kNsPerSecond;
  const bool acquired = sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &until) == 0;
#ifdef __SANITIZE_THREAD__
  if (acquired) __tsan_acquire(&semaphore_);  // which knows sem_post(), but not this wait (GCC 12)
#endif
  return acquired;
}

TextFile::~TextFile() {
  close();
}

bool TextFile::open(const std::string& path, Writing writing) {
  if (path == "-") return open(STDOUT_FILENO, writing);
  constexpr int kReadWriteForAll = 0666;
  // Without O_NONBLOCK, opening a FIFO without a reader would block: ENXIO.
  constexpr int kFlags = O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK;
  int file = ::open(path.c_str(), kFlags);
  const bool is_new = file < 0 && errno == ENOENT;
  if (is_new) file = ::open(path.c_str(), kFlags | O_CREAT, kReadWriteForAll);
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0) {
    error_ = errno;
  } else if (!is_new && !takes_output(status)) {
    error_ = S_ISREG(status.st_mode) ? EACCES : EINVAL;
  }
  if (failed()) {
    if (file >= 0) ::close(file);
    return false;
  }
  owns_ = true;
  if (!open(file, writing)) {
    ::close(std::exchange(descriptor_, -1));
    return false;
  }
  replaces_ = status.st_size > 0;
  path_ = path;
  made_ = is_new;
  return true;
}

bool TextFile::open(int descriptor, Writing writing) {
  descriptor_ = descriptor;
  // poll() guarantees room for PIPE_BUF bytes in a pipe; a file on a disk takes everything.
  struct stat status {};
  const bool is_regular = fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  most_at_once_ = is_regular ? kBufferBytes : std::size_t{PIPE_BUF};
  start(writing);
  return !failed();
}

void TextFile::start(Writing writing) {
  writing_ = writing;
  const bool in_background = writing != Writing::direct;
  buffers_.resize(in_background ? kBackgroundBuffers + 1 : 1);
  for (Buffer& buffer : buffers_) buffer.text = std::make_unique<char[]>(kBufferBytes);
  if (in_background) {
    empty_.release(kBackgroundBuffers - 1);  // all but the one that is being filled
    try {
      writer_ = thread_without_signals([this] { write_in_background(); });
    } catch (const std::system_error&) {
      error_ = ENOMEM;  // there is no room for its stack, or no more threads
    }
  }
}

bool TextFile::is_same_file(const TextFile& other) const {
  struct stat mine {
  }, its{};
  return is_open() && other.is_open() && fstat(descriptor_, &mine) == 0 &&
         fstat(other.descriptor_, &its) == 0 && S_ISREG(mine.st_mode) &&
         mine.st_dev == its.st_dev && mine.st_ino == its.st_ino;
}

bool TextFile::is_same_file(const std::string& path) const {
  struct stat mine {
  }, its{};
  return is_open() && fstat(descriptor_, &mine) == 0 && stat(path.c_str(), &its) == 0 &&
         S_ISREG(mine.st_mode) && mine.st_dev == its.st_dev && mine.st_ino == its.st_ino;
}

bool TextFile::reserve() {
  struct stat mine {};
  if (fstat(descriptor_, &mine) != 0 || !S_ISREG(mine.st_mode)) return true;
  reserved_ = flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
  if (!reserved_ && errno == EWOULDBLOCK) return false;  // some file systems have no locks
  if (path_.empty() || !is_claimed(path_)) return true;
  let_go();
  return false;
}

/// Said, because a process that fork() made may still have the descriptor.
void TextFile::let_go() {
  if (std::exchange(reserved_, false)) flock(descriptor_, LOCK_UN);
}

bool TextFile::close() {
  if (!is_open()) return error() == 0;
  writing_ = Writing::background;  // nothing is left that could be late
  flush();
  stop();
  if (replaces_ && !failed() && ftruncate(descriptor_, 0) != 0) error_ = errno;
  let_go();
  if (owns_ && ::close(descriptor_) != 0 && error() == 0) error_ = errno;
  descriptor_ = -1;
  return error() == 0;
}

void TextFile::discard() {
  if (!is_open()) return;
  used_ = 0;
  stop();
  struct stat mine {
  }, its{};
  const bool is_ours = made_ && fstat(descriptor_, &mine) == 0 && mine.st_size == 0 &&
                       lstat(path_.c_str(), &its) == 0 && mine.st_dev == its.st_dev &&
                       mine.st_ino == its.st_ino;
  if (is_ours) unlink(path_.c_str());
  let_go();
  if (owns_) ::close(descriptor_);
  descriptor_ = -1;
}

void TextFile::stop() {
  if (!writer_.joinable()) return;
  flush();  // an empty buffer is the end, and so is any after a failure
  writer_.join();
}

void TextFile::text(std::string_view text) {
  while (!text.empty()) {
    if (used_ == kBufferBytes) flush();
    const std::size_t n = std::min(text.size(), kBufferBytes - used_);
    std::memcpy(buffer() + used_, text.data(), n);
    used_ += n;
    text.remove_prefix(n);
  }
}

void TextFile::flush() {
  const std::size_t used = std::exchange(used_, 0);
  if (!writer_.joinable()) {
    buffers_[current_].used = used;
    return write(buffers_[current_]);
  }
  if (current_ != kScratch) {
    buffers_[current_].used = used;
    current_ = (current_ + 1) % kBackgroundBuffers;
    full_.release();
  }
  if (current_ != kScratch && !wait_for_room()) {
    current_ = kScratch;
    full_.release();  // the writer may be waiting for more
  }
}

/// False if there will be none.
bool TextFile::wait_for_room() {
  using namespace std::chrono_literals;
  if (empty_.try_acquire()) return true;
  if (writing_ == Writing::real_time) return error_ = ETIMEDOUT, false;
  while (!empty_.try_acquire_for(100ms)) {
    if (failed()) return false;
  }
  return true;
}

void TextFile::write_in_background() {
  for (std::size_t i = 0;; i = (i + 1) % kBackgroundBuffers) {
    while (!full_.acquire_within(kIdleMs)) is_due_ = true;
    is_due_ = false;
    if (buffers_[i].used == 0) return;
    write(buffers_[i]);
    if (failed()) return;
    empty_.release();
  }
}

void TextFile::write(const Buffer& buffer) {
  // Only now, when its replacement is complete.
  if (replaces_ && buffer.used > 0) {
    replaces_ = false;
    if (ftruncate(descriptor_, 0) != 0) error_ = errno;
  }
  const char* from = buffer.text.get();
  std::size_t left = buffer.used;
  while (left > 0 && wait_for_reader()) {
    const ssize_t written = ::write(descriptor_, from, std::min(left, most_at_once_));
    if (written < 0) {
      if (errno != EINTR && errno != EAGAIN) error_ = errno;
      continue;
    }
    from += written;
    left -= static_cast<std::size_t>(written);
  }
}

/// False after a failure. A reader may take as long as it wants, until somebody wants the end.
bool TextFile::wait_for_reader() {
  constexpr int kPollMs = 100;
  constexpr int kPatienceMs = 1'000;
  int waited_ms = 0;
  while (!failed()) {
    pollfd item{descriptor_, POLLOUT, 0};
    if (::poll(&item, 1, kPollMs) != 0) return true;  // what is wrong, write() says
    waited_ms = interrupted() ? waited_ms + kPollMs : 0;
    if (waited_ms >= kPatienceMs) error_ = ETIMEDOUT;
  }
  return false;
}

}  // namespace eagerx::host

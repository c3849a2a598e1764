#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <targets/linux-sim/text_file.hpp>

namespace eagerx::linux_sim {

TextFile::~TextFile() {
  close();
}

bool TextFile::open(const std::string& path, Writing writing) {
  constexpr int kReadWriteForAll = 0666;
  descriptor_ = path == "-" ? STDOUT_FILENO
                            : ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC,
                                     kReadWriteForAll);
  if (descriptor_ < 0) return error_ = errno, false;
  const bool in_background = writing == Writing::background;
  buffers_.resize(in_background ? kBackgroundBuffers : 1);
  for (Buffer& buffer : buffers_) buffer.text = std::make_unique<char[]>(kBufferBytes);
  if (in_background) {
    empty_.release(kBackgroundBuffers - 1);  // all but the one that is being filled
    // Signals are for the thread that sleeps until the next step.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    writer_ = std::thread([this] { write_in_background(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  return true;
}

bool TextFile::close() {
  if (!is_open()) return error() == 0;
  flush();
  if (writer_.joinable()) {
    flush();  // an empty buffer is the end
    writer_.join();
  }
  if (descriptor_ != STDOUT_FILENO && ::close(descriptor_) != 0 && error() == 0) error_ = errno;
  descriptor_ = -1;
  return error() == 0;
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
  buffers_[current_].used = used_;
  used_ = 0;
  if (!writer_.joinable()) return write(buffers_[current_]);
  full_.release();
  current_ = (current_ + 1) % buffers_.size();
  empty_.acquire();
}

void TextFile::write_in_background() {
  for (std::size_t i = 0;; i = (i + 1) % buffers_.size()) {
    full_.acquire();
    if (buffers_[i].used == 0) return;
    write(buffers_[i]);
    empty_.release();
  }
}

void TextFile::write(const Buffer& buffer) {
  const char* from = buffer.text.get();
  std::size_t left = buffer.used;
  while (left > 0 && error() == 0) {
    const ssize_t written = ::write(descriptor_, from, left);
    if (written < 0) {
      if (errno != EINTR) error_ = errno;
      continue;
    }
    from += written;
    left -= static_cast<std::size_t>(written);
  }
}

}  // namespace eagerx::linux_sim

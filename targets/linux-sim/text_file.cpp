#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <targets/linux-sim/text_file.hpp>

namespace eagerx::linux_sim {

TextFile::~TextFile() {
  close();
}

bool TextFile::open(const std::string& path) {
  constexpr int kReadWriteForAll = 0666;
  descriptor_ = path == "-" ? STDOUT_FILENO
                            : ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC,
                                     kReadWriteForAll);
  if (descriptor_ < 0) return error_ = errno, false;
  buffer_ = std::make_unique<char[]>(kBufferBytes);
  return true;
}

bool TextFile::close() {
  if (!is_open()) return error_ == 0;
  flush();
  if (descriptor_ != STDOUT_FILENO && ::close(descriptor_) != 0 && error_ == 0) error_ = errno;
  descriptor_ = -1;
  return error_ == 0;
}

void TextFile::text(std::string_view text) {
  while (!text.empty()) {
    if (used_ == kBufferBytes) flush();
    const std::size_t n = std::min(text.size(), kBufferBytes - used_);
    std::memcpy(buffer_.get() + used_, text.data(), n);
    used_ += n;
    text.remove_prefix(n);
  }
}

void TextFile::flush() {
  const char* from = buffer_.get();
  while (used_ > 0 && error_ == 0) {
    const ssize_t written = ::write(descriptor_, from, used_);
    if (written < 0) {
      if (errno != EINTR) error_ = errno;
      continue;
    }
    from += written;
    used_ -= static_cast<std::size_t>(written);
  }
  used_ = 0;
}

}  // namespace eagerx::linux_sim

// Files of Linux: system calls, and a handle that is all zero while it is closed.
#pragma once

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <string_view>

namespace eagerx::links {

/// The kernel. Drivers take it as a template parameter: tests put one in its place that answers as
/// a device would.
struct Kernel {
  static int open(const char* path, int flags) { return ::open(path, flags | O_CLOEXEC); }
  static int close(int file) { return ::close(file); }
  static int ioctl(int file, std::uintptr_t request, void* argument) {
    int result = 0;
    do {
      result = ::ioctl(file, request, argument);
    } while (result < 0 && errno == EINTR);
    return result;
  }
};

/// An open file. No copy closes it: its opener does.
class File {
 public:
  /// False if it cannot be opened.
  template <class System = Kernel>
  bool open(const char* path, int flags) {
    close<System>();
    return adopt(System::open(path, flags));
  }
  /// Takes ownership of a descriptor; false if it is negative.
  bool adopt(int file) {
    plus_one_ = file < 0 ? 0 : file + 1;
    return is_open();
  }
  template <class System = Kernel>
  void close() {
    if (is_open()) System::close(handle());
    plus_one_ = 0;
  }
  bool is_open() const { return plus_one_ != 0; }
  int handle() const { return plus_one_ - 1; }

 private:
  int plus_one_ = 0;
};

/// The bus error for an error number of a driver.
inline BusError error_of(int number) {
  switch (number) {
    case ENXIO:
    case EREMOTEIO:
      return BusError::nak;  // Documentation/i2c/fault-codes.rst
    case ETIMEDOUT:
    case EAGAIN:
    case EBUSY:
      return BusError::timeout;
    case EINVAL:
    case EOPNOTSUPP:
    case ENOTTY:
    case EMSGSIZE:
      return BusError::unsupported;
    default:
      return BusError::link_lost;
  }
}

/// f(word) for each word of a text; false as soon as f returns that.
template <class F>
bool for_each_word(std::string_view text, const F& f) {
  while (true) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return true;
    text.remove_prefix(begin);
    const std::size_t end = text.find(' ') == std::string_view::npos ? text.size() : text.find(' ');
    if (!f(text.substr(0, end))) return false;
    text.remove_prefix(end);
  }
}

/// A path that the kernel can read: with a zero at its end.
class Path {
 public:
  /// Too long a path becomes an empty one, which nothing can open.
  explicit Path(std::string_view first, std::string_view second = "") {
    if (first.size() + second.size() >= sizeof text_) return;
    std::size_t n = first.copy(text_, first.size());
    n += second.copy(text_ + n, second.size());
    text_[n] = '\0';
  }
  const char* text() const { return text_; }

 private:
  char text_[256] = {};
};

}  // namespace eagerx::links

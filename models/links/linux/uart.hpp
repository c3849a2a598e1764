// A serial line on Linux: a tty. Source: ioctl_tty(2), termios(3).
#pragma once

#include <asm/termbits.h>
#include <poll.h>
#include <sys/file.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <models/links/linux/clock.hpp>
#include <models/links/linux/file.hpp>

namespace eagerx::links {

/// 8 data bits, no parity, 1 stop bit, any rate that the hardware has. A UartBus. All bytes are
/// zero until open().
class LinuxUart {
 public:
  /// Opens the line exclusively. False if it does not exist, if another program uses it, or if it
  /// does not support this rate.
  bool open(const char* path, std::uint32_t baud, int timeout_ms) {
    timeout_ms_ = timeout_ms;
    if (!file_.open(path, O_RDWR | O_NOCTTY | O_NONBLOCK)) return false;
    // The lock also excludes root, to whom TIOCEXCL does not apply.
    if (flock(file_.handle(), LOCK_EX | LOCK_NB) != 0) return file_.close(), false;
    Kernel::ioctl(file_.handle(), TIOCEXCL, nullptr);
    termios2 line{};
    if (Kernel::ioctl(file_.handle(), TCGETS2, &line) < 0) return close(), false;
    line.c_iflag = 0;
    line.c_oflag = 0;
    line.c_lflag = 0;
    line.c_cflag = CS8 | CREAD | CLOCAL | BOTHER;
    line.c_ispeed = baud;
    line.c_ospeed = baud;
    if (Kernel::ioctl(file_.handle(), TCSETS2, &line) < 0) return close(), false;
    flush();
    return true;
  }
  void close() {
    if (is_open()) Kernel::ioctl(file_.handle(), TIOCNXCL, nullptr);
    file_.close();
  }
  bool is_open() const { return file_.is_open(); }

  /// Errors: timeout, link_lost.
  BusError write(const std::uint8_t* out, std::size_t n) {
    return carry_out(n, POLLOUT, [&](std::size_t done) {
      return ::write(file_.handle(), out + done, n - done);
    });
  }
  /// Errors: timeout, short_reply (a part came in time), link_lost.
  BusError read(std::uint8_t* in, std::size_t n) {
    return carry_out(n, POLLIN,
                     [&](std::size_t done) { return ::read(file_.handle(), in + done, n - done); });
  }
  /// Discards received bytes.
  void flush() {
    if (file_.is_open()) ::ioctl(file_.handle(), TCFLSH, TCIFLUSH);
  }

 private:
  template <class Step>
  BusError carry_out(std::size_t n, std::int16_t event, const Step& step) {
    constexpr std::int64_t kNsPerMs = 1'000'000;
    const std::int64_t end = LinuxClock::now_ns() + timeout_ms_ * kNsPerMs;
    for (std::size_t done = 0; done < n;) {
      if (!file_.is_open()) return BusError::link_lost;
      const std::int64_t left_ns = end - LinuxClock::now_ns();
      if (left_ns <= 0) return late(event, done);  // poll() would wait for ever
      pollfd wanted{file_.handle(), event, 0};
      const int ready = ::poll(&wanted, 1, static_cast<int>((left_ns + kNsPerMs - 1) / kNsPerMs));
      if (ready < 0 && errno == EINTR) continue;
      if (ready == 0) return late(event, done);
      const ssize_t more = ready < 0 ? -1 : step(done);
      if (more > 0) {
        done += static_cast<std::size_t>(more);
      } else if (more == 0 || (errno != EAGAIN && errno != EINTR)) {
        close();
      }
    }
    return BusError::none;
  }
  static BusError late(std::int16_t event, std::size_t done) {
    return event == POLLIN && done > 0 ? BusError::short_reply : BusError::timeout;
  }

  File file_;
  int timeout_ms_ = 0;
};

static_assert(UartBus<LinuxUart>);

}  // namespace eagerx::links

// A serial line on a chip of FTDI.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <models/links/ftdi/linux/ftdi_device.hpp>
#include <models/links/linux/clock.hpp>

namespace eagerx::links {

/// 8 data bits, no parity, 1 stop bit. A UartBus. A chip that is gone is looked for again by
/// write(), at most every kRetryNs.
class FtdiUart {
 public:
  using Clock = LinuxClock;
  static constexpr std::int64_t kRetryNs = 100'000'000;

  /// False if the chip is not there (yet) or does not have this rate.
  bool open(const FtdiSelection& selection, int baud, int timeout_ms) {
    selection_ = selection;
    baud_ = baud;
    timeout_ms_ = timeout_ms;
    return connect();
  }
  void close() { device_.free(); }
  bool is_open() const { return device_.is_open(); }

  BusError write(const std::uint8_t* out, std::size_t n) {
    if (!device_.is_open() && baud_ != 0 && Clock::now_ns() - tried_ns_ >= kRetryNs) connect();
    return device_.is_open() ? checked(device_.write(out, n)) : BusError::link_lost;
  }
  BusError read(std::uint8_t* in, std::size_t n) {
    constexpr std::int64_t kNsPerMs = 1'000'000;
    if (!device_.is_open()) return BusError::link_lost;
    return checked(device_.read<Clock>(in, n, Clock::now_ns() + timeout_ms_ * kNsPerMs));
  }
  /// Discards received bytes.
  void flush() {
    if (device_.is_open()) ftdi_tcioflush(device_.context());
  }

 private:
  bool connect() {
    tried_ns_ = Clock::now_ns();
    if (!device_.open(selection_, timeout_ms_)) return false;
    if (ftdi_set_bitmode(device_.context(), 0, BITMODE_RESET) < 0 ||
        ftdi_set_baudrate(device_.context(), baud_) < 0 ||
        ftdi_set_line_property(device_.context(), BITS_8, STOP_BIT_1, NONE) < 0 ||
        ftdi_tcioflush(device_.context()) < 0) {
      return device_.close(), false;
    }
    return true;
  }
  BusError checked(BusError error) {
    if (error == BusError::link_lost) device_.close();
    return error;
  }

  FtdiDevice device_{};
  FtdiSelection selection_{};
  std::int64_t tried_ns_ = 0;
  int baud_ = 0;
  int timeout_ms_ = 0;
};

static_assert(UartBus<FtdiUart>);

}  // namespace eagerx::links

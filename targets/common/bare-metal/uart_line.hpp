// A serial line for drivers, over any UART of a board.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::board {

/// A UartBus over `Port`, which has put(byte) and take(byte&, error&), on `Clock` (now_ns()). It
/// polls: while the program does not read, only as many characters as the hardware keeps survive.
template <class Port, class Clock>
class UartLine {
 public:
  /// Writing and reading wait at most `timeout_ns` for each byte.
  UartLine(const Port& port, std::int64_t timeout_ns) : port_(port), timeout_ns_(timeout_ns) {}

  /// Errors: timeout.
  BusError write(const std::uint8_t* out, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto put = [&] { return port_.put(out[i]); };
      if (!in_time(put)) return BusError::timeout;
    }
    return BusError::none;
  }
  /// Errors: timeout, frame, short_reply (bytes were lost). Call flush() after an error.
  BusError read(std::uint8_t* in, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      BusError error = BusError::none;
      const auto take = [&] { return port_.take(in[i], error); };
      if (!in_time(take)) return BusError::timeout;
      if (error != BusError::none) return error;
    }
    return BusError::none;
  }
  /// Discards received bytes.
  void flush() {
    std::uint8_t byte = 0;
    BusError error = BusError::none;
    while (port_.take(byte, error)) {
    }
  }

 private:
  template <class F>
  bool in_time(const F& done) {
    if (done()) return true;
    const std::int64_t end = Clock::now_ns() + timeout_ns_;
    while (Clock::now_ns() < end) {
      if (done()) return true;
    }
    return done();
  }

  Port port_;
  std::int64_t timeout_ns_;
};

}  // namespace eagerx::board

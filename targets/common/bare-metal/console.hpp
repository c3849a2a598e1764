// Text output of a board, through semihosting or a serial port, without printf and heap.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <targets/common/bare-metal/decimal.hpp>

namespace eagerx::board {

/// Exit codes, the same numbers as a Linux program's where there is one.
inline constexpr int kDone = 0;
inline constexpr int kSelfTestFailed = 1;
inline constexpr int kBadUsage = 2;
inline constexpr int kFault = 4;
inline constexpr int kTooLate = 5;

enum class Output : std::uint8_t { semihosting, uart };

/// Sends one character through the board's serial port. Every board defines it.
void uart_write(char character);
/// Sends the byte if the port has room for it now, otherwise returns false. Every board whose
/// manifest has a `baud` defines it; programs with telemetry call it.
bool uart_offer(std::uint8_t byte);
/// Reads a received character from the serial port; false if there is none. It uses no interrupts,
/// so call it continuously to wait for characters. Boards that only send do not need it.
bool uart_read(char& character);

/// Collects text and sends it when a line is complete or the buffer full.
class Console {
 public:
  void send_to(Output output) { output_ = output; }
  void text(std::string_view text);
  /// Up to its end; of the library's strlen alone there would be 200 bytes.
  void text(const char* text);
  void flush();

  /// Decimal integers, and floating-point numbers as the shortest decimal that reads back to the
  /// same bits, like std::to_chars on Linux.
  template <std::integral T>
  void number(T value) {
    char buffer[kLongestInteger];
    text({buffer, write_integer(buffer, value)});
  }
  template <std::floating_point T>
  void number(T value) {
    char buffer[Decimal<T>::kLongestText];
    text({buffer, Decimal<T>::write(buffer, value)});
  }

  /// All hexadecimal digits of an unsigned number.
  template <std::unsigned_integral T>
  void hex(T value) {
    constexpr unsigned kBitsPerDigit = 4;
    for (unsigned shift = 8 * sizeof(T); shift > 0;) {
      shift -= kBitsPerDigit;
      text({&"0123456789abcdef"[(value >> shift) & 0xfU], 1});
    }
  }

 private:
  [[gnu::noinline]] void put(char character);

  static constexpr std::size_t kBufferBytes = 128;

  char buffer_[kBufferBytes];
  std::size_t used_;
  Output output_;
};

/// The only one. All-zero at the start: it sends through semihosting.
extern constinit Console console;

}  // namespace eagerx::board

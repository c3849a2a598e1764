// Transfers of a SPI or I2C bus as one stream of commands for FTDI's MPSSE.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::links {

/// The differences between the chips.
struct MpsseChip {
  bool open_drain;       // FT232H: outputs can be driven to zero only
  bool high_byte;        // ACBUS/BCBUS is there (not on FT4232H)
  std::uint32_t max_hz;  // limit of the wiring for all devices; 0: 30 MHz, the chip's own
};

/// Collects transfers; `bytes()` are the bytes to send, and `deliver()` copies the answer to the
/// buffers. Call use() first. A batch is one write and one read over USB. Pins of the low byte: 0
/// clock, 1 data out (I2C: SDA, tied to 2), 2 data in, 3 to 7 select lines 0 to 4, which are high
/// at rest. Pins of the high byte: GPIO 0 to 7, inputs until they are written.
///
/// SPI modes 0 and 2 are the chip's own (AN_114). Of modes 1 and 3 the first edge, at which a
/// device puts out its first bit, is made by hand after the select line has fallen; what follows is
/// the chip's mode 2 or 0, and the clock goes back to rest after the select line has risen.
/// Sources: FTDI AN_108 (commands, and the level at which the clock must start), AN_114 (SPI),
/// AN_113 and AN_255 (I2C).
class MpsseBatch {
 public:
  static constexpr std::size_t kMaxBytes = 4096;
  static constexpr std::size_t kMaxReply = 1024;  // the chip's buffer: more would block it
  static constexpr std::size_t kMaxReads = 256;
  static constexpr std::size_t kSelects = 5;

  void use(MpsseChip chip) {
    chip_ = chip;
    forget();
  }
  /// Marks the chip's state as unknown: the next transfer sets everything again.
  void forget() {
    clear();
    divisor_ = kUnknown;
    phases_ = kUnknown;
    drain_ = kUnknown;
  }
  void clear() {
    size_ = 0;
    reply_ = 0;
    reads_ = 0;
    error_ = BusError::none;
  }

  const std::uint8_t* bytes() const { return bytes_; }
  std::size_t size() const { return size_; }
  std::size_t reply_size() const { return reply_; }
  /// full or unsupported if a transfer could not be added; the batch must then not be sent.
  BusError error() const { return error_; }

  void spi(SpiDevice device, const std::uint8_t* out, std::uint8_t* in, std::size_t n) {
    if (n == 0) return;
    if (device.select >= kSelects || device.mode > 3) return fail(BusError::unsupported);
    const bool high_at_rest = (device.mode & 2U) != 0;
    const bool edge_by_hand = (device.mode & 1U) != 0;
    const bool high_at_start = high_at_rest != edge_by_hand;
    clock(device.max_hz, false);
    drain(false);
    const auto selects = static_cast<std::uint8_t>(kSelectPins & ~(1U << (device.select + 3U)));
    pins(kSelectPins, high_at_rest);  // the clock is at rest before the select line falls
    // Devices want some hundred nanoseconds (AS5048A 350) from there to the first edge.
    for (int i = 0; i < 3; ++i) pins(selects, high_at_rest);
    if (edge_by_hand) pins(selects, high_at_start);
    // Out on the falling, in on the rising edge; the other way round for a clock that starts high.
    unsigned command = high_at_start ? 0x10U : 0x11U;
    if (in != nullptr) command |= high_at_start ? 0x24U : 0x20U;
    add(static_cast<std::uint8_t>(command));
    add(low_byte(static_cast<std::uint16_t>(n - 1)));
    add(high_byte(static_cast<std::uint16_t>(n - 1)));
    for (std::size_t i = 0; i < n; ++i) add(out[i]);
    if (in != nullptr) expect({in, nullptr, nullptr, static_cast<std::uint16_t>(n), 0});
    if (edge_by_hand) pins(kSelectPins, high_at_start);
    // Three times: as long between two words.
    for (int i = 0; i < 3; ++i) pins(kSelectPins, high_at_rest);
  }

  void i2c(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
           std::size_t m, BusError& status) {
    status = BusError::none;
    clock(device.max_hz, true);
    drain(chip_.open_drain);
    const auto address = static_cast<unsigned>(device.address) << 1U;
    if (n > 0 || m == 0) {
      start();
      write_byte(static_cast<std::uint8_t>(address), status);
      for (std::size_t i = 0; i < n; ++i) write_byte(out[i], status);
    }
    if (m > 0) {
      start();
      write_byte(static_cast<std::uint8_t>(address | 1U), status);
      for (std::size_t i = 0; i < m; ++i) read_byte(in + i, i + 1 == m);
    }
    stop();
  }

  /// GPIO 0 to 7 of the high byte. A written pin is an output from then on.
  void write_pin(std::uint8_t pin, bool level) {
    if (!chip_.high_byte || pin > 7) return fail(BusError::unsupported);
    const auto bit = static_cast<std::uint8_t>(1U << pin);
    high_outputs_ = static_cast<std::uint8_t>(high_outputs_ | bit);
    high_values_ = static_cast<std::uint8_t>(level ? high_values_ | bit : high_values_ & ~bit);
    add(0x82);
    add(high_values_);
    add(high_outputs_);
  }
  void read_pin(std::uint8_t pin, bool& level) {
    if (!chip_.high_byte || pin > 7) return fail(BusError::unsupported);
    add(0x83);
    expect({nullptr, nullptr, &level, 1, static_cast<std::uint8_t>(1U << pin)});
  }

  /// Ends the stream: the chip answers immediately instead of waiting for its latency timer.
  void finish() {
    if (reply_ > 0) add(0x87);
  }

  /// The `reply_size()` bytes of the answer.
  void deliver(const std::uint8_t* reply) {
    for (std::size_t i = 0; i < reads_; ++i) {
      const Read& read = read_[i];
      if (read.bytes != nullptr) {
        for (std::size_t k = 0; k < read.n; ++k) read.bytes[k] = reply[k];
      } else if (read.pin != nullptr) {
        *read.pin = (reply[0] & read.mask) != 0;
      } else if ((reply[0] & 1U) != 0) {  // the acknowledge bit is low
        *read.status = BusError::nak;
      }
      reply += read.n;
    }
  }

  static constexpr std::uint16_t divisor_of(std::uint32_t hz) {
    constexpr std::uint32_t kHalf = 30'000'000;  // f = 60 MHz / (2·(1 + divisor))
    if (hz == 0 || hz >= kHalf) return 0;
    const std::uint32_t divisor = (kHalf + hz - 1) / hz - 1;
    return divisor < 0xffffU ? static_cast<std::uint16_t>(divisor) : std::uint16_t{0xffff};
  }

 private:
  struct Read {
    std::uint8_t* bytes;
    BusError* status;  // of an acknowledge bit
    bool* pin;
    std::uint16_t n;
    std::uint8_t mask;
  };
  static constexpr std::uint32_t kUnknown = 0xffffffff;
  static constexpr unsigned kClock = 0x01;
  static constexpr unsigned kData = 0x02;
  static constexpr unsigned kSelectPins = 0xf8;
  static constexpr std::uint8_t kSpiOutputs = 0xfb;

  void fail(BusError error) {
    if (error_ == BusError::none) error_ = error;
  }
  void add(std::uint8_t byte) {
    if (size_ == kMaxBytes) return fail(BusError::full);
    bytes_[size_++] = byte;
  }
  void expect(Read read) {
    if (reads_ == kMaxReads || reply_ + read.n > kMaxReply) return fail(BusError::full);
    read_[reads_++] = read;
    reply_ += read.n;
  }
  void low_pins(std::uint8_t values, std::uint8_t outputs) {
    add(0x80);
    add(values);
    add(outputs);
  }
  void pins(unsigned selects, bool clock_high) {
    low_pins(static_cast<std::uint8_t>(selects | (clock_high ? kClock : 0U)), kSpiOutputs);
  }

  void clock(std::uint32_t hz, bool three_phases) {
    if (chip_.max_hz != 0 && (hz == 0 || hz > chip_.max_hz)) hz = chip_.max_hz;
    if (phases_ != std::uint32_t{three_phases}) {
      phases_ = std::uint32_t{three_phases};
      add(three_phases ? 0x8c : 0x8d);
    }
    const std::uint16_t divisor = divisor_of(hz);
    if (divisor_ == divisor) return;
    divisor_ = divisor;
    add(0x86);
    add(low_byte(divisor));
    add(high_byte(divisor));
  }
  void drain(bool on) {
    if (!chip_.open_drain || drain_ == std::uint32_t{on}) return;
    drain_ = std::uint32_t{on};
    add(0x9e);
    add(on ? 0x07 : 0x00);
    add(0x00);
  }

  // I2C: levels of clock and data; a released data line is an input where there is no open drain.
  void lines(bool scl, bool sda) {
    const auto values =
        static_cast<std::uint8_t>(kSelectPins | (scl ? kClock : 0U) | (sda ? kData : 0U));
    const bool released = sda && !chip_.open_drain;
    low_pins(values, static_cast<std::uint8_t>(released ? kSpiOutputs & ~kData : kSpiOutputs));
  }
  // Every level four times: 600 ns and more at standard and fast mode.
  void hold(bool scl, bool sda) {
    for (int i = 0; i < 4; ++i) lines(scl, sda);
  }
  void start() {
    hold(false, true);  // a repeated start begins with the clock low
    hold(true, true);
    hold(true, false);
    hold(false, false);
  }
  void stop() {
    hold(false, false);
    hold(true, false);
    hold(true, true);
  }
  void write_byte(std::uint8_t byte, BusError& status) {
    if (!chip_.open_drain) lines(false, false);  // an output again
    add(0x11);
    add(0x00);
    add(0x00);
    add(byte);
    lines(false, true);
    add(0x22);
    add(0x00);
    expect({nullptr, &status, nullptr, 1, 0});
  }
  void read_byte(std::uint8_t* to, bool last) {
    lines(false, true);
    add(0x20);
    add(0x00);
    add(0x00);
    expect({to, nullptr, nullptr, 1, 0});
    if (!chip_.open_drain) lines(false, false);
    add(0x13);
    add(0x00);
    add(last ? 0xff : 0x00);
    lines(false, true);
  }

  MpsseChip chip_{};
  std::uint8_t bytes_[kMaxBytes]{};
  Read read_[kMaxReads]{};
  std::size_t size_ = 0;
  std::size_t reply_ = 0;
  std::size_t reads_ = 0;
  std::uint32_t divisor_ = 0;
  std::uint32_t phases_ = 0;
  std::uint32_t drain_ = 0;
  std::uint8_t high_values_ = 0;
  std::uint8_t high_outputs_ = 0;
  BusError error_ = BusError::none;
};

}  // namespace eagerx::links

// The FT232H itself: MPSSE commands (FTDI AN_108) and the serial line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <targets/emulated-ftdi/devices.hpp>

namespace eagerx::emulated {

/// Bytes on their way to the host.
class Fifo {
 public:
  static constexpr std::size_t kSize = 8192;
  void put(std::uint8_t byte) {
    if (size_ < kSize) bytes_[(head_ + size_++) % kSize] = byte;
  }
  std::uint8_t take() {
    const std::uint8_t byte = bytes_[head_];
    head_ = (head_ + 1) % kSize;
    --size_;
    return byte;
  }
  void keep(std::size_t n) { size_ = n < size_ ? n : size_; }
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }

 private:
  std::array<std::uint8_t, kSize> bytes_{};
  std::size_t head_ = 0;
  std::size_t size_ = 0;
};

/// The state of the data line from the devices.
enum class DataLine : std::uint8_t { works, stuck_low, stuck_high };

class Chip {
 public:
  static constexpr std::size_t kSelects = 5;

  void wire(std::size_t select, SpiSlave& slave) { spi_[select] = &slave; }
  void wire(I2cSlave& slave) { i2c_[i2c_slaves_++] = &slave; }
  void wire(SerialSlave& slave) { serial_ = &slave; }

  /// Power on, and bitmode as libftdi's ftdi_set_bitmode has it (0 serial line, 2 MPSSE).
  void reset();
  void set_mode(std::uint8_t mode);
  /// Forgets commands that are not complete.
  void purge() { pending_ = 0; }

  /// Processes the bytes that the host sent at `now_ns`; the answer goes to `to_host`. Commands may
  /// be split anywhere.
  void take(const std::uint8_t* bytes, std::size_t n, std::int64_t now_ns, Fifo& to_host);
  /// When the last command is through.
  std::int64_t busy_until_ns() const { return at_ns_; }

  /// Of all chips, only the FT232H can drive pins to zero only (0x9e).
  void set_open_drain(bool there) { has_open_drain_ = there; }
  void set_data_line(DataLine line) { line_ = line; }
  void refuse_next_i2c_byte() { refuse_ = true; }
  std::uint8_t high_pins() const { return high_values_; }
  void set_high_inputs(std::uint8_t levels) { high_inputs_ = levels; }
  /// SPI transfers in a clock mode that the device does not understand.
  std::uint64_t wrong_modes() const { return wrong_modes_; }

 private:
  static constexpr std::size_t kPending = 8192;
  bool has_open_drain_ = true;

  /// Carries out the command at `bytes` and returns its length, 0 if it is not complete.
  std::size_t command(const std::uint8_t* bytes, std::size_t n, Fifo& to_host);
  std::size_t data_bytes(const std::uint8_t* bytes, std::size_t n, Fifo& to_host);
  std::size_t data_bits(const std::uint8_t* bytes, std::size_t n, Fifo& to_host);
  void set_low_pins(std::uint8_t values, std::uint8_t outputs);
  std::uint8_t exchange(std::uint8_t out, std::uint8_t opcode);
  void i2c_lines(bool scl, bool sda);
  void i2c_byte(std::uint8_t byte);
  SpiSlave* selected() const;
  bool understands(const SpiSlave& slave, std::uint8_t opcode) const;
  std::int64_t bit_ns() const;

  std::array<SpiSlave*, kSelects> spi_{};
  std::array<I2cSlave*, 4> i2c_{};
  std::size_t i2c_slaves_ = 0;
  SerialSlave* serial_ = nullptr;

  std::array<std::uint8_t, kPending> bytes_{};
  std::size_t pending_ = 0;
  std::int64_t at_ns_ = 0;
  std::uint8_t mode_ = 0;
  std::uint8_t low_values_ = 0;
  std::uint8_t low_outputs_ = 0;
  std::uint8_t high_values_ = 0;
  std::uint8_t high_outputs_ = 0;
  std::uint8_t high_inputs_ = 0;
  std::uint32_t divisor_ = 0;
  bool three_phases_ = false;
  bool rests_high_ = false;          // the clock, when a select line moved last
  std::uint32_t edges_by_hand_ = 0;  // of the clock since then, by setting pins
  bool divides_by_five_ = true;
  DataLine line_ = DataLine::works;
  std::uint64_t wrong_modes_ = 0;

  bool scl_ = true;
  bool sda_ = true;
  bool addressing_ = false;  // the next byte is an address
  bool acknowledged_ = false;
  bool refuse_ = false;
  I2cSlave* active_ = nullptr;
};

}  // namespace eagerx::emulated

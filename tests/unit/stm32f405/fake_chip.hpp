// The registers of a STM32F405 as far as RM0090 says what they do, with devices on its pins. A
// peripheral whose clock is off reads as 0 and takes nothing, as on the chip.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <targets/emulated-ftdi/devices.hpp>
#include <utility>
#include <vector>

namespace eagerx::board::testing {

/// Time that passes by waiting only.
struct FakeTime {
  static inline std::int64_t now = 1;
  static std::int64_t now_ns() { return now; }
  static bool sleep_until(std::int64_t ns) {
    if (ns > now) now = ns;
    return true;
  }
  static void at_least_ns(std::uint32_t ns) { now += ns; }
};

class FakeChip {
 public:
  using Address = std::uintptr_t;
  struct Write {
    Address address;
    std::uint32_t value;
    friend bool operator==(const Write&, const Write&) = default;
  };

  std::vector<Write> writes;            // all of them
  std::map<Address, std::uint32_t> at;  // plain registers
  std::uint32_t last_spi_control = 0;
  bool is_silent = false;  // SPI and ADC never finish

  /// A device on SPI1 with its select line at pin `number` of port A.
  void wire(unsigned number, emulated::SpiSlave& slave) { slaves_[number] = &slave; }
  void wire(emulated::I2cSlave& slave) { i2c_slave_ = &slave; }
  std::string serial_in, serial_out;  // of USART1
  std::string serial_answer;          // comes in after this many bytes
  std::size_t serial_question = 0;
  std::uint32_t serial_errors = 0;                // flags of the next character that comes in
  std::map<std::uint32_t, std::uint32_t> analog;  // counts of ADC channels
  std::size_t i2c_bytes_read = 0;
  bool i2c_last_not_acknowledged = false;
  bool holds_sda = false;  // some device holds the line low, for 5 clocks
  int scl_pulses = 0;

  std::uint32_t read(Address a) {
    if (!is_open(a)) return 0;
    switch (a) {
      case kSpi1 + 0x08:
        return is_silent ? 0x80U : 0x2U | (spi_received_ ? 1U : 0U);
      case kSpi1 + 0x0c:
        spi_received_ = false;
        return spi_data_;
      case kUsart1:
        return 0x80U | (serial_in.empty() ? 0U : 0x20U | serial_errors);
      case kUsart1 + 4:
        return take_serial();
      case kAdc:
        return at[kAdc];
      case kPortB + 0x10:
        return holds_sda && scl_pulses < 5 ? ~(1U << 7U) : ~0U;
      case kI2c1:
        return i2c_control();
      case kI2c1 + 0x10:
        return i2c_take();
      case kI2c1 + 0x14:
        return i2c_status();
      case kI2c1 + 0x18:
        return i2c_status2();
      default:
        return at[a];
    }
  }

  void write(Address a, std::uint32_t value) {
    writes.push_back({a, value});
    if (!is_open(a)) return;
    if (a == kPortA + 0x18) return set_pins(value);
    if (a == kPortB + 0x18) return count_clocks(value);
    if (a == kSpi1 + 0x0c) return spi(value);
    if (a == kUsart1 + 4) {
      serial_out.push_back(static_cast<char>(value));
      if (serial_out.size() == serial_question) serial_in += serial_answer;
      return;
    }
    if (a == kI2c1 + 0x10) return i2c_send(value);
    if (a == kI2c1 + 0x14) {
      i2c_flags_ &= ~kNak;
      return;
    }
    at[a] = value;
    if (a == kSpi1) last_spi_control = value;
    if (a == kI2c1) i2c_command(value);
    if (a == kAdc + 8 && (value & 1U << 30U) != 0 && !is_silent) convert();
  }

 private:
  static constexpr Address kPortA = 0x40020000;
  static constexpr Address kPortB = 0x40020400;
  static constexpr Address kSpi1 = 0x40013000;
  static constexpr Address kUsart1 = 0x40011000;
  static constexpr Address kAdc = 0x40012000;
  static constexpr Address kI2c1 = 0x40005400;
  static constexpr std::uint32_t kNak = 1U << 10U;

  /// 7.3.10 to 7.3.14: what has a gate here.
  bool is_open(Address a) {
    const auto gate = [&](Address reg, unsigned bit) { return (at[reg] >> bit & 1U) != 0; };
    if (a >= kPortA && a < kPortA + 9 * 0x400)
      return gate(0x40023830, static_cast<unsigned>((a - kPortA) / 0x400));
    const Address block = a & ~Address{0x3ff};
    if (block == kSpi1) return gate(0x40023844, 12);
    if (block == kUsart1) return gate(0x40023844, 4);
    if (block == kAdc) return gate(0x40023844, 8);
    if (block == 0x40010000) return gate(0x40023844, 0);
    if (block == kI2c1) return gate(0x40023840, 21);
    if (block >= 0x40000000 && block <= 0x40000c00)
      return gate(0x40023840, static_cast<unsigned>((block - 0x40000000) / 0x400));
    return true;
  }

  void set_pins(std::uint32_t value) {
    for (const auto& [pin, slave] : slaves_) {
      if ((value >> pin & 1U) != 0 && selected_ == slave) {
        selected_ = nullptr;
        slave->release(FakeTime::now);
      }
      if ((value >> (pin + 16) & 1U) != 0) {
        selected_ = slave;
        slave->select(FakeTime::now);
      }
    }
  }
  void count_clocks(std::uint32_t value) {
    if ((value >> 6U & 1U) != 0) ++scl_pulses;
  }
  void spi(std::uint32_t value) {
    const std::uint32_t control = at[kSpi1];
    const bool right = selected_ != nullptr && (control & 0x40U) != 0 && (control & 0x4U) != 0 &&
                       (control & 0x3U) == swapped(selected_->mode());
    spi_data_ = right ? selected_->exchange(static_cast<std::uint8_t>(value)) : 0;
    spi_received_ = true;
  }
  /// CPOL is bit 1 of a mode and of CR1, CPHA bit 0 of both.
  static std::uint32_t swapped(unsigned mode) { return mode; }

  std::uint32_t take_serial() {
    if (serial_in.empty()) return 0;
    const auto byte = static_cast<unsigned char>(serial_in.front());
    serial_in.erase(serial_in.begin());
    serial_errors = 0;
    return byte;
  }
  void convert() {
    at[kAdc] |= 2U;
    at[kAdc + 0x4c] = analog[at[kAdc + 0x34] & 0x1fU];
  }

  // I2C, 27.3.3: flags of the first status as the sequence of the manual has them.
  void i2c_command(std::uint32_t value) {
    if ((value & 0x8000U) != 0) {  // software reset
      i2c_flags_ = 0;
      i2c_busy_ = false;
    }
    if ((value & 0x100U) != 0) {
      i2c_flags_ = 1;  // start
      i2c_busy_ = true;
      i2c_reading_ = false;
      at[kI2c1] &= ~0x100U;
    }
    if ((value & 0x200U) != 0) i2c_stop_ = true;
  }
  std::uint32_t i2c_control() {
    if (i2c_stop_ && !(i2c_reading_ && !i2c_last_not_acknowledged && i2c_slave_ != nullptr)) {
      i2c_stop_ = false;
      i2c_busy_ = false;
      at[kI2c1] &= ~0x200U;
    }
    return at[kI2c1];
  }
  void i2c_send(std::uint32_t value) {
    if ((i2c_flags_ & 1U) != 0) {
      const bool there = i2c_slave_ != nullptr && i2c_slave_->address() == value >> 1U;
      i2c_reading_ = there && (value & 1U) != 0;
      i2c_flags_ = there ? 2U : kNak;
      i2c_fifo_.clear();
      i2c_last_not_acknowledged = false;
      if (there && !i2c_reading_) i2c_slave_->begin();
      return;
    }
    i2c_slave_->write(static_cast<std::uint8_t>(value));
    i2c_flags_ = 0x84;  // transmitter empty, byte done
  }
  /// A byte comes in whenever there is room: two, in the data and the shift register.
  std::uint32_t i2c_status() {
    if (holds_sda && scl_pulses < 5) return 0;
    if (i2c_reading_ && (i2c_flags_ & 3U) == 0) {
      if (i2c_fifo_.size() < 2 && !i2c_last_not_acknowledged) {
        i2c_fifo_.push_back(i2c_slave_->read());
        ++i2c_bytes_read;
        const bool second = (at[kI2c1] & 0x800U) != 0 && i2c_fifo_.size() == 1;  // POS
        i2c_last_not_acknowledged = (at[kI2c1] & 0x400U) == 0 && !second;
      }
      i2c_flags_ = (i2c_fifo_.empty() ? 0U : 0x40U) | (i2c_fifo_.size() == 2 ? 4U : 0U);
    }
    return i2c_flags_;
  }
  std::uint32_t i2c_status2() {
    if ((i2c_flags_ & 2U) != 0) i2c_flags_ = i2c_reading_ ? 0 : 0x80;  // addressed
    return (i2c_busy_ || (holds_sda && scl_pulses < 5)) ? 2U : 0U;
  }
  std::uint32_t i2c_take() {
    if (i2c_fifo_.empty()) return 0;
    const std::uint8_t byte = i2c_fifo_.front();
    i2c_fifo_.erase(i2c_fifo_.begin());
    return byte;
  }

  std::map<unsigned, emulated::SpiSlave*> slaves_;
  emulated::SpiSlave* selected_ = nullptr;
  bool spi_received_ = false;
  std::uint32_t spi_data_ = 0;
  emulated::I2cSlave* i2c_slave_ = nullptr;
  std::uint32_t i2c_flags_ = 0;
  bool i2c_busy_ = false;
  bool i2c_reading_ = false;
  bool i2c_stop_ = false;
  std::vector<std::uint8_t> i2c_fifo_;
};

/// The memory that the drivers take for the chip's.
struct FakeMemory {
  static inline FakeChip* chip = nullptr;
  static std::uint32_t read(std::uintptr_t address) { return chip->read(address); }
  static void write(std::uintptr_t address, std::uint32_t value) { chip->write(address, value); }
};

}  // namespace eagerx::board::testing

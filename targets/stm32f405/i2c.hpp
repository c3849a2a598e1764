// I2C of the STM32F405, as a master. Source: ST RM0090, rev 19, chapter 27; pins: DS8626, table 9.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/stm32f405/gpio.hpp>

namespace eagerx::board::stm32 {

struct I2cPins {
  Pin scl, sda;
};

/// One of the three, with the pins it can be at; their alternate function is 4.
struct I2cPort {
  std::uintptr_t base;
  Gate gate;
  I2cPins first, second;

  constexpr bool has(const I2cPins& pins) const {
    return (pins.scl == first.scl || pins.scl == second.scl) &&
           (pins.sda == first.sda || pins.sda == second.sda);
  }
};
inline constexpr I2cPort kI2c1{0x40005400,
                               {rcc::kApb1Enable, 21},
                               {pin_of("PB6"), pin_of("PB7")},
                               {pin_of("PB8"), pin_of("PB9")}};
inline constexpr I2cPort kI2c2{0x40005800,
                               {rcc::kApb1Enable, 22},
                               {pin_of("PB10"), pin_of("PB11")},
                               {pin_of("PF1"), pin_of("PF0")}};
inline constexpr I2cPort kI2c3{0x40005C00,
                               {rcc::kApb1Enable, 23},
                               {pin_of("PA8"), pin_of("PC9")},
                               {pin_of("PH7"), pin_of("PH8")}};

/// 100 or 400 kHz, 7-bit addresses, without interrupts: a transfer takes its time. All bytes are
/// zero until start(). `Wait::at_least_ns(n)` times the clock pulses that free a stuck line.
template <class Wait, class Memory = MappedMemory>
class I2c {
 public:
  /// False if these pins are not the port's.
  bool start(const I2cPort& port, const I2cPins& pins, std::uint32_t max_hz) {
    if (!port.has(pins)) return false;
    port_ = &port;
    pins_ = pins;
    max_hz_ = max_hz;
    open<Memory>(port.gate);
    restart();
    return true;
  }

  /// Writes n bytes, then reads m after a repeated start. Errors: unsupported (not started, slower
  /// than 100 kHz), nak, timeout (a line is held low, arbitration is lost); after a timeout the
  /// lines are freed by clock pulses.
  BusError transfer(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
                    std::size_t m) {
    const std::uint32_t limit = device.max_hz < max_hz_ ? device.max_hz : max_hz_;
    if (port_ == nullptr || limit < kStandardHz) return BusError::unsupported;
    set_speed(limit >= kFastHz);
    BusError error = is_free() ? BusError::none : BusError::timeout;
    if (error == BusError::none && (n > 0 || m == 0)) error = send(device.address, out, n);
    if (error == BusError::none && m > 0) error = receive(device.address, in, m);
    if (error == BusError::timeout) {
      restart();
      return error;
    }
    if (error == BusError::nak || m == 0) set_bits<Memory>(reg(kControl1), kStop);
    return wait_for_stop() ? error : BusError::timeout;
  }

 private:
  static constexpr std::uintptr_t kControl1 = 0x00;
  static constexpr std::uintptr_t kControl2 = 0x04;
  static constexpr std::uintptr_t kData = 0x10;
  static constexpr std::uintptr_t kStatus1 = 0x14;
  static constexpr std::uintptr_t kStatus2 = 0x18;
  static constexpr std::uintptr_t kClock = 0x1c;
  static constexpr std::uintptr_t kRiseTime = 0x20;

  static constexpr std::uint32_t kOn = 1U << 0U;
  static constexpr std::uint32_t kStart = 1U << 8U;
  static constexpr std::uint32_t kStop = 1U << 9U;
  static constexpr std::uint32_t kAcknowledge = 1U << 10U;
  static constexpr std::uint32_t kAcknowledgeNext = 1U << 11U;  // POS
  static constexpr std::uint32_t kReset = 1U << 15U;

  static constexpr std::uint32_t kStarted = 1U << 0U;
  static constexpr std::uint32_t kAddressed = 1U << 1U;
  static constexpr std::uint32_t kByteDone = 1U << 2U;
  static constexpr std::uint32_t kReceived = 1U << 6U;
  static constexpr std::uint32_t kTransmitEmpty = 1U << 7U;
  static constexpr std::uint32_t kWrong = 1U << 8U | 1U << 9U;  // bus error, arbitration lost
  static constexpr std::uint32_t kNotAcknowledged = 1U << 10U;
  static constexpr std::uint32_t kBusy = 1U << 1U;  // of the second status

  static constexpr std::uint8_t kFunction = 4;
  static constexpr std::uint32_t kStandardHz = 100'000;
  static constexpr std::uint32_t kFastHz = 400'000;
  static constexpr std::uint32_t kBusMHz = kApb1Hz / 1'000'000;
  // Reads of the status: some milliseconds, where a byte takes 0.1.
  static constexpr std::uint32_t kPatience = 100'000;

  std::uintptr_t reg(std::uintptr_t offset) const { return port_->base + offset; }

  /// 27.6.8, 27.6.9: rise times of 1 us and 0.3 us.
  void set_speed(bool fast) {
    if (is_set_ && fast == fast_) return;
    is_set_ = true;
    fast_ = fast;
    constexpr std::uint32_t kFast = 1U << 15U;
    Memory::write(reg(kControl1), 0);
    Memory::write(reg(kControl2), kBusMHz);
    Memory::write(reg(kClock), fast ? kFast | (kApb1Hz + 3 * kFastHz - 1) / (3 * kFastHz)
                                    : (kApb1Hz + 2 * kStandardHz - 1) / (2 * kStandardHz));
    Memory::write(reg(kRiseTime), fast ? kBusMHz * 3 / 10 + 1 : kBusMHz + 1);
    Memory::write(reg(kControl1), kOn);
  }

  /// Up to nine clock pulses let a device that was interrupted finish its byte; then the peripheral
  /// is reset (27.6.1, SWRST) and gets its pins.
  void restart() {
    using Pins = Gpio<Memory>;
    Pins::make_open_drain(pins_.sda, true);
    Pins::make_open_drain(pins_.scl, true);
    for (int i = 0; i < 9 && !Pins::read(pins_.sda); ++i) {
      Pins::write(pins_.scl, false);
      Wait::at_least_ns(kHalfClockNs);
      Pins::write(pins_.scl, true);
      Wait::at_least_ns(kHalfClockNs);
    }
    Pins::make_alternate(pins_.scl, kFunction, PinPull::up, true);
    Pins::make_alternate(pins_.sda, kFunction, PinPull::up, true);
    Memory::write(reg(kControl1), kReset);
    Memory::write(reg(kControl1), 0);
    is_set_ = false;
  }

  BusError send(std::uint8_t address, const std::uint8_t* out, std::size_t n) {
    BusError error = begin(static_cast<std::uint8_t>(address << 1U));
    if (error != BusError::none) return error;
    static_cast<void>(Memory::read(reg(kStatus2)));  // with the read before, clears "addressed"
    for (std::size_t i = 0; i < n; ++i) {
      error = wait(kTransmitEmpty);
      if (error != BusError::none) return error;
      Memory::write(reg(kData), out[i]);
    }
    return n > 0 ? wait(kByteDone) : BusError::none;
  }

  /// 27.3.3, master receiver: the last byte is not acknowledged, and the stop is requested before
  /// the last bytes are read, in a way that depends on their number.
  BusError receive(std::uint8_t address, std::uint8_t* in, std::size_t m) {
    const std::uint32_t mode = m == 1 ? 0 : m == 2 ? kAcknowledge | kAcknowledgeNext : kAcknowledge;
    change_bits<Memory>(reg(kControl1), kAcknowledge | kAcknowledgeNext, mode);
    BusError error = begin(static_cast<std::uint8_t>(unsigned{address} << 1U | 1U));
    if (error != BusError::none) return error;
    static_cast<void>(Memory::read(reg(kStatus2)));
    std::size_t i = 0;
    if (m == 1) {
      set_bits<Memory>(reg(kControl1), kStop);
      return take(kReceived, in[0]);
    }
    if (m == 2) clear_bits<Memory>(reg(kControl1), kAcknowledge);
    for (; i + 3 < m; ++i) {
      error = take(kReceived, in[i]);
      if (error != BusError::none) return error;
    }
    if (m > 2) {
      error = wait(kByteDone);
      if (error != BusError::none) return error;
      clear_bits<Memory>(reg(kControl1), kAcknowledge);
      in[i++] = byte();
    }
    error = wait(kByteDone);
    if (error != BusError::none) return error;
    set_bits<Memory>(reg(kControl1), kStop);
    in[i] = byte();
    return take(kReceived, in[i + 1]);
  }

  /// Start and address.
  BusError begin(std::uint8_t address) {
    set_bits<Memory>(reg(kControl1), kStart);
    const BusError error = wait(kStarted);
    if (error != BusError::none) return error;
    Memory::write(reg(kData), address);
    return wait(kAddressed);
  }
  BusError take(std::uint32_t when, std::uint8_t& value) {
    const BusError error = wait(when);
    if (error == BusError::none) value = byte();
    return error;
  }
  std::uint8_t byte() const { return static_cast<std::uint8_t>(Memory::read(reg(kData)) & 0xffU); }

  BusError wait(std::uint32_t bit) const {
    for (std::uint32_t i = 0; i < kPatience; ++i) {
      const std::uint32_t status = Memory::read(reg(kStatus1));
      if ((status & kNotAcknowledged) != 0) {
        Memory::write(reg(kStatus1), 0);  // 0 clears, 1 changes nothing
        return BusError::nak;
      }
      if ((status & kWrong) != 0) return BusError::timeout;
      if ((status & bit) != 0) return BusError::none;
    }
    return BusError::timeout;
  }
  /// The bus is busy for a moment after a stop, and while a device holds a line.
  bool is_free() const {
    for (std::uint32_t i = 0; i < kPatience; ++i) {
      if (!has_bits<Memory>(reg(kStatus2), kBusy)) return true;
    }
    return false;
  }
  /// The hardware takes the bit away when the stop is out; nothing may be written before.
  bool wait_for_stop() {
    for (std::uint32_t i = 0; i < kPatience; ++i) {
      if (!has_bits<Memory>(reg(kControl1), kStop)) return true;
    }
    restart();
    return false;
  }

  static constexpr std::uint32_t kHalfClockNs = 5'000;

  const I2cPort* port_ = nullptr;
  I2cPins pins_{};
  std::uint32_t max_hz_ = 0;
  bool is_set_ = false;
  bool fast_ = false;
};

}  // namespace eagerx::board::stm32

// SPI of the STM32F405, as a master. Source: ST RM0090, rev 19, chapter 28; pins: DS8626, table 9.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/stm32f405/gpio.hpp>

namespace eagerx::board::stm32 {

/// Pins of one SPI: clock, master in slave out, master out slave in.
struct SpiPins {
  Pin sck, miso, mosi;
};

/// One of the three; a line can be at one of two pins.
struct SpiPort {
  std::uintptr_t base;
  Gate gate;
  std::uint32_t bus_hz;
  std::uint8_t function;
  SpiPins first, second;

  constexpr bool has(const SpiPins& pins) const {
    return (pins.sck == first.sck || pins.sck == second.sck) &&
           (pins.miso == first.miso || pins.miso == second.miso) &&
           (pins.mosi == first.mosi || pins.mosi == second.mosi);
  }
};
inline constexpr SpiPort kSpi1{0x40013000,
                               {rcc::kApb2Enable, 12},
                               kApb2Hz,
                               5,
                               {pin_of("PA5"), pin_of("PA6"), pin_of("PA7")},
                               {pin_of("PB3"), pin_of("PB4"), pin_of("PB5")}};
inline constexpr SpiPort kSpi2{0x40003800,
                               {rcc::kApb1Enable, 14},
                               kApb1Hz,
                               5,
                               {pin_of("PB13"), pin_of("PB14"), pin_of("PB15")},
                               {pin_of("PB10"), pin_of("PC2"), pin_of("PC3")}};
inline constexpr SpiPort kSpi3{0x40003C00,
                               {rcc::kApb1Enable, 15},
                               kApb1Hz,
                               6,
                               {pin_of("PB3"), pin_of("PB4"), pin_of("PB5")},
                               {pin_of("PC10"), pin_of("PC11"), pin_of("PC12")}};

/// Words of 8 bits, most significant bit first; the select lines are ordinary outputs.
/// `Wait::at_least_ns(n)` keeps a select line high between two transfers, and low before the first
/// edge of the clock: 400 ns, which the AS5048 (350 ns for both) and all others here need. All
/// bytes are zero until start().
template <class Wait, class Memory = MappedMemory>
class Spi {
 public:
  /// False if these pins are not the port's.
  bool start(const SpiPort& port, const SpiPins& pins, std::uint32_t max_hz) {
    if (!port.has(pins)) return false;
    port_ = &port;
    max_hz_ = max_hz;
    open<Memory>(port.gate);
    Gpio<Memory>::make_alternate(pins.sck, port.function);
    Gpio<Memory>::make_alternate(pins.miso, port.function, PinPull::down);
    Gpio<Memory>::make_alternate(pins.mosi, port.function);
    return true;
  }
  /// Select lines are outputs that are high when nothing is selected.
  static void add_select(Pin pin) { Gpio<Memory>::make_output(pin, true); }

  /// Sends n bytes to the device at `select` and receives as many; `in` may be null. Errors:
  /// unsupported (not started; the device's clock would be slower than bus_hz/256), timeout.
  BusError transfer(SpiDevice device, Pin select, const std::uint8_t* out, std::uint8_t* in,
                    std::size_t n) const {
    std::uint32_t control = 0;
    if (port_ == nullptr || !control_of(device, control)) return BusError::unsupported;
    Memory::write(port_->base + kControl1, control);  // before the select line: the clock's level
    Memory::write(port_->base + kControl1, control | kOn);
    static_cast<void>(Memory::read(port_->base + kData));  // whatever an error left there
    Gpio<Memory>::write(select, false);
    Wait::at_least_ns(kSelectedNs);
    BusError error = BusError::none;
    for (std::size_t i = 0; i < n && error == BusError::none; ++i) {
      std::uint8_t answer = 0;
      error = exchange(out[i], answer);
      if (in != nullptr) in[i] = answer;
    }
    if (error == BusError::none && !wait(kBusy, 0)) error = BusError::timeout;
    Gpio<Memory>::write(select, true);
    Wait::at_least_ns(kHighNs);
    return error;
  }

  /// CR1 for a device: master, select managed by software; the fastest clock that it, the wiring
  /// and the dividers 2 to 256 allow. False if there is none.
  bool control_of(SpiDevice device, std::uint32_t& control) const {
    const std::uint32_t limit = device.max_hz < max_hz_ ? device.max_hz : max_hz_;
    std::uint32_t divider = 0;
    while (divider < kDividers && port_->bus_hz >> (divider + 1) > limit) ++divider;
    if (divider == kDividers || device.mode > 3) return false;
    const std::uint32_t phase = device.mode & 1U;
    const std::uint32_t polarity = device.mode >> 1U;
    control = kMaster | phase | polarity << 1U | divider << 3U;
    return true;
  }

 private:
  static constexpr std::uintptr_t kControl1 = 0x00;
  static constexpr std::uintptr_t kStatus = 0x08;
  static constexpr std::uintptr_t kData = 0x0c;
  static constexpr std::uint32_t kOn = 1U << 6U;
  static constexpr std::uint32_t kMaster = 1U << 9U | 1U << 8U | 1U << 2U;  // SSM, SSI, MSTR
  static constexpr std::uint32_t kReceived = 1U << 0U;
  static constexpr std::uint32_t kTransmitEmpty = 1U << 1U;
  static constexpr std::uint32_t kBusy = 1U << 7U;
  static constexpr std::uint32_t kDividers = 8;
  static constexpr std::uint32_t kHighNs = 400;
  static constexpr std::uint32_t kSelectedNs = 400;
  // Reads of the status: some milliseconds, where a byte takes 0.05 at most.
  static constexpr std::uint32_t kPatience = 100'000;

  BusError exchange(std::uint8_t out, std::uint8_t& in) const {
    if (!wait(kTransmitEmpty, kTransmitEmpty)) return BusError::timeout;
    Memory::write(port_->base + kData, out);
    if (!wait(kReceived, kReceived)) return BusError::timeout;
    in = static_cast<std::uint8_t>(Memory::read(port_->base + kData) & 0xffU);
    return BusError::none;
  }
  bool wait(std::uint32_t bits, std::uint32_t level) const {
    for (std::uint32_t i = 0; i < kPatience; ++i) {
      if ((Memory::read(port_->base + kStatus) & bits) == level) return true;
    }
    return false;
  }

  const SpiPort* port_ = nullptr;
  std::uint32_t max_hz_ = 0;
};

}  // namespace eagerx::board::stm32

// Serial lines of the STM32F405. Source: ST RM0090, rev 19, chapter 30; pins: DS8626, table 9.
#pragma once

#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/stm32f405/gpio.hpp>

namespace eagerx::board::stm32 {

/// One of the six USARTs; `function` is the alternate function of its pins.
struct UsartPort {
  std::uintptr_t base;
  Gate gate;
  std::uint32_t bus_hz;
  std::uint8_t function;
};
inline constexpr UsartPort kUsart1{0x40011000, {rcc::kApb2Enable, 4}, kApb2Hz, 7};
inline constexpr UsartPort kUsart2{0x40004400, {rcc::kApb1Enable, 17}, kApb1Hz, 7};
inline constexpr UsartPort kUsart3{0x40004800, {rcc::kApb1Enable, 18}, kApb1Hz, 7};
inline constexpr UsartPort kUart4{0x40004C00, {rcc::kApb1Enable, 19}, kApb1Hz, 8};
inline constexpr UsartPort kUart5{0x40005000, {rcc::kApb1Enable, 20}, kApb1Hz, 8};
inline constexpr UsartPort kUsart6{0x40011400, {rcc::kApb2Enable, 5}, kApb2Hz, 8};

/// 8 data bits, no parity, 1 stop bit, without interrupts: the hardware keeps one character that
/// came in, so take() has to be called at least once in ten bit times (87 us at 115200 baud).
template <class Memory = MappedMemory>
class Uart {
 public:
  explicit constexpr Uart(const UsartPort& port) : port_(port) {}

  /// False if there is no such pin, or the baud rate is outside bus_hz/65535 to bus_hz/16.
  bool start(Pin transmit, Pin receive, std::uint32_t baud) const {
    if (transmit == kNoPin || receive == kNoPin || baud == 0) return false;
    const std::uint32_t divider = (port_.bus_hz + baud / 2) / baud;  // mantissa and sixteenths
    if (divider < kLeastDivider || divider > kMostDivider) return false;
    open<Memory>(port_.gate);
    Gpio<Memory>::make_alternate(transmit, port_.function);
    // An undriven line reads as idle.
    Gpio<Memory>::make_alternate(receive, port_.function, PinPull::up);
    Memory::write(port_.base + kBaudRate, divider);
    Memory::write(port_.base + kControl1, kOn);
    return true;
  }
  bool is_on() const { return has_bits<Memory>(port_.base + kControl1, kOn); }

  /// Sends a byte if there is room for it.
  bool put(std::uint8_t byte) const {
    if (!has_bits<Memory>(port_.base + kStatus, kTransmitEmpty)) return false;
    Memory::write(port_.base + kData, byte);
    return true;
  }
  /// False if nothing has come in. `error`: frame (stop bit or noise), short_reply (a byte before
  /// this one was lost), otherwise none.
  bool take(std::uint8_t& byte, BusError& error) const {
    const std::uint32_t status = Memory::read(port_.base + kStatus);
    if ((status & kReceived) == 0) return false;
    byte = static_cast<std::uint8_t>(Memory::read(port_.base + kData) & 0xffU);  // clears flags
    error = (status & (kFraming | kNoise)) != 0 ? BusError::frame
            : (status & kOverrun) != 0          ? BusError::short_reply
                                                : BusError::none;
    return true;
  }

 private:
  static constexpr std::uintptr_t kStatus = 0x00;
  static constexpr std::uintptr_t kData = 0x04;
  static constexpr std::uintptr_t kBaudRate = 0x08;
  static constexpr std::uintptr_t kControl1 = 0x0c;
  static constexpr std::uint32_t kFraming = 1U << 1U;
  static constexpr std::uint32_t kNoise = 1U << 2U;
  static constexpr std::uint32_t kOverrun = 1U << 3U;
  static constexpr std::uint32_t kReceived = 1U << 5U;
  static constexpr std::uint32_t kTransmitEmpty = 1U << 7U;
  static constexpr std::uint32_t kOn = 1U << 13U | 1U << 3U | 1U << 2U;  // UE, TE, RE
  static constexpr std::uint32_t kLeastDivider = 16;
  static constexpr std::uint32_t kMostDivider = 0xffff;

  UsartPort port_;
};

}  // namespace eagerx::board::stm32

// Pins of the STM32F405. Source: ST RM0090, rev 19, chapter 8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <string_view>
#include <targets/stm32f405/registers.hpp>

namespace eagerx::board::stm32 {

/// Pin `number` (0 to 15) of port `port` (0: A).
struct Pin {
  std::uint8_t port;
  std::uint8_t number;

  friend constexpr bool operator==(Pin, Pin) = default;
};
inline constexpr Pin kNoPin{0xff, 0xff};

/// The pin of a name such as "PA9"; kNoPin if the chip has no such pin.
constexpr Pin pin_of(std::string_view name) {
  constexpr std::size_t kShortest = 3;
  constexpr std::size_t kLongest = 4;
  if (name.size() < kShortest || name.size() > kLongest || name[0] != 'P') return kNoPin;
  if (name[1] < 'A' || name[1] > 'I') return kNoPin;
  unsigned number = 0;
  for (std::size_t i = 2; i < name.size(); ++i) {
    if (name[i] < '0' || name[i] > '9') return kNoPin;
    number = number * 10 + static_cast<unsigned>(name[i] - '0');
  }
  if (number > 15 || (name.size() == kLongest && name[2] == '0')) return kNoPin;
  return {static_cast<std::uint8_t>(name[1] - 'A'), static_cast<std::uint8_t>(number)};
}

/// The mode of a pin (8.4.1, 8.4.2, 8.4.4).
enum class PinMode : std::uint8_t { input, output, alternate, analog };
enum class PinPull : std::uint8_t { none, up, down };

template <class Memory = MappedMemory>
class Gpio {
 public:
  static void make_input(Pin pin, PinPull pull = PinPull::none) {
    start(pin);
    set_pull(pin, pull);
    set_mode(pin, PinMode::input);
  }
  /// The level is set before the pin becomes an output: it makes no spike.
  static void make_output(Pin pin, bool level) {
    start(pin);
    write(pin, level);
    set_mode(pin, PinMode::output);
  }
  /// An output that pulls down or lets go, with a pull-up.
  static void make_open_drain(Pin pin, bool level) {
    start(pin);
    set_pull(pin, PinPull::up);
    set_bits<Memory>(reg(pin, kOpenDrain), 1U << pin.number);
    write(pin, level);
    set_mode(pin, PinMode::output);
  }
  static void make_analog(Pin pin) {
    start(pin);
    set_mode(pin, PinMode::analog);
  }
  /// Gives the pin to a peripheral: `function` 0 to 15 of DS8626, table 9. I2C wants `open_drain`.
  static void make_alternate(Pin pin, std::uint8_t function, PinPull pull = PinPull::none,
                             bool open_drain = false) {
    start(pin);
    set_pull(pin, pull);
    change_bits<Memory>(reg(pin, kOpenDrain), 1U << pin.number,
                        (open_drain ? 1U : 0U) << pin.number);
    change_bits<Memory>(reg(pin, kSpeed), two(pin, 3), two(pin, kFast));
    const std::uintptr_t functions = reg(pin, pin.number < 8 ? kAlternateLow : kAlternateHigh);
    const unsigned shift = 4U * (pin.number % 8U);
    change_bits<Memory>(functions, 0xfU << shift, std::uint32_t{function} << shift);
    set_mode(pin, PinMode::alternate);
  }

  static void write(Pin pin, bool level) {
    Memory::write(reg(pin, kSetReset), 1U << (pin.number + (level ? 0U : 16U)));
  }
  static bool read(Pin pin) { return (Memory::read(reg(pin, kInput)) >> pin.number & 1U) != 0; }

 private:
  static constexpr std::uintptr_t kMode = 0x00;
  static constexpr std::uintptr_t kOpenDrain = 0x04;
  static constexpr std::uintptr_t kSpeed = 0x08;
  static constexpr std::uintptr_t kPull = 0x0c;
  static constexpr std::uintptr_t kInput = 0x10;
  static constexpr std::uintptr_t kSetReset = 0x18;
  static constexpr std::uintptr_t kAlternateLow = 0x20;
  static constexpr std::uintptr_t kAlternateHigh = 0x24;
  static constexpr std::uint32_t kFast = 2;  // 50 MHz

  static std::uintptr_t reg(Pin pin, std::uintptr_t offset) {
    constexpr std::uintptr_t kPortA = 0x40020000;
    constexpr std::uintptr_t kPortBytes = 0x400;
    return kPortA + pin.port * kPortBytes + offset;
  }
  /// `value` in the two bits of this pin.
  static std::uint32_t two(Pin pin, std::uint32_t value) { return value << (2U * pin.number); }

  static void start(Pin pin) { open<Memory>({rcc::kAhb1Enable, pin.port}); }
  static void set_mode(Pin pin, PinMode mode) {
    change_bits<Memory>(reg(pin, kMode), two(pin, 3), two(pin, static_cast<std::uint32_t>(mode)));
  }
  static void set_pull(Pin pin, PinPull pull) {
    change_bits<Memory>(reg(pin, kPull), two(pin, 3), two(pin, static_cast<std::uint32_t>(pull)));
  }
};

}  // namespace eagerx::board::stm32

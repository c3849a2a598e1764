// A digital-to-analogue converter of Microchip on SPI: MCP4921.
#pragma once

#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::drivers {

/// 12 bits, one output, V = V_REF · code / 4096 at gain 1. SPI mode 0, up to 20 MHz; a command is a
/// 16-bit word that takes effect at the rising edge of the select line:
///   15 zero (write), 14 buffered reference, 13 gain 1 (0: gain 2), 12 output on, 11…0 code
/// Source: Microchip DS22248A, register 5-2. The device sends nothing, so nothing is checked.
class Mcp4921 {
 public:
  static constexpr std::uint16_t kMaxCode = 4095;
  static constexpr std::uint32_t kMaxHz = 20'000'000;

  /// The word that puts out `code`, at gain 1 and with an unbuffered reference.
  static constexpr std::uint16_t write_command(std::uint16_t code) {
    return static_cast<std::uint16_t>(kGainOne | kOutputOn | (code < kMaxCode ? code : kMaxCode));
  }
  /// The word that switches the output off (500 kΩ to ground).
  static constexpr std::uint16_t shutdown_command() { return kGainOne; }

  /// The nearest code for `volts` with a reference of `reference` V, limited to the codes that
  /// exist; NaN is 0.
  template <class Real>
  static constexpr std::uint16_t code_of(Real volts, Real reference) {
    const Real code = volts / reference * Real(4096) + Real(0.5);
    if (!(code >= Real(0))) return 0;
    return code >= Real(kMaxCode) ? kMaxCode : static_cast<std::uint16_t>(code);
  }

  template <SpiBus Bus>
  static void write(Bus& bus, std::uint8_t select, std::uint16_t code) {
    send(bus, select, write_command(code));
  }
  template <SpiBus Bus>
  static void shut_down(Bus& bus, std::uint8_t select) {
    send(bus, select, shutdown_command());
  }

 private:
  static constexpr std::uint16_t kGainOne = 0x2000;
  static constexpr std::uint16_t kOutputOn = 0x1000;

  template <class Bus>
  static void send(Bus& bus, std::uint8_t select, std::uint16_t command) {
    const std::uint8_t bytes[2] = {high_byte(command), low_byte(command)};
    bus.spi({select, 0, kMaxHz}, bytes, nullptr, 2);
  }
};

}  // namespace eagerx::drivers

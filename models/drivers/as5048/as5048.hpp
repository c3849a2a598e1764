// Magnetic angle encoders of ams on SPI: AS5048A and AS5047D/P.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::drivers {

/// Registers of the AS5048A: ams data sheet DS000298 v4, SPI interface and register map.
struct As5048A {
  static constexpr std::uint16_t kClearErrors = 0x0001;  // reading it clears the error flag
  static constexpr std::uint16_t kDiagnostics = 0x3ffd;  // 11 comp high, 10 comp low, 9 COF, 8 OCF
  static constexpr std::uint16_t kAngle = 0x3fff;
};
/// Registers of the AS5047D and AS5047P: ams data sheets v1, register map.
struct As5047 {
  static constexpr std::uint16_t kClearErrors = 0x0001;  // ERRFL
  static constexpr std::uint16_t kDiagnostics = 0x3ffc;  // 11 MAGL, 10 MAGH, 9 COF, 8 LF
  static constexpr std::uint16_t kAngle = 0x3fff;        // ANGLECOM
};

/// A 14-bit absolute angle, checked. SPI mode 1, up to 10 MHz, words of 16 bits:
///   command  15 even parity of 14…0, 14 read, 13…0 address
///   answer   15 even parity of 14…0, 14 error flag, 13…0 data
/// The answer to a command comes with the next one, and the select line is high for at least
/// 350 ns between two words. So a sample is three words: angle, diagnostics, no operation. The
/// diagnostics have a bit that is always set once the encoder measures, which also finds a data
/// line that is stuck at 0 (whose parity would be right).
template <class Registers = As5048A>
class MagneticEncoder {
 public:
  static constexpr std::uint32_t kCountsPerTurn = 16384;
  static constexpr std::uint32_t kMaxHz = 10'000'000;

  /// Reading command for a register, with its parity.
  static constexpr std::uint16_t read_command(std::uint16_t address) {
    return with_parity(static_cast<std::uint16_t>(kRead | address));
  }
  /// `word` with bit 15 such that the number of ones is even.
  static constexpr std::uint16_t with_parity(std::uint16_t word) {
    const auto data = static_cast<std::uint16_t>(word & 0x7fffU);
    return static_cast<std::uint16_t>(data | (is_odd(data) ? 0x8000U : 0U));
  }
  static constexpr bool is_odd(std::uint16_t word) {
    unsigned bits = word;
    bits ^= bits >> 8U;
    bits ^= bits >> 4U;
    bits ^= bits >> 2U;
    bits ^= bits >> 1U;
    return (bits & 1U) != 0;
  }

  /// Queues a sample. After an error flag it also queues the reading that clears it.
  template <SpiBus Bus>
  void request(Bus& bus, std::uint8_t select) {
    const SpiDevice device{select, 1, kMaxHz};
    if (clear_) transfer(bus, device, read_command(Registers::kClearErrors), nullptr);
    transfer(bus, device, read_command(Registers::kAngle), nullptr);
    transfer(bus, device, read_command(Registers::kDiagnostics), angle_);
    transfer(bus, device, kNoOperation, diagnostics_);
  }

  /// After run(): the angle in counts, 0 to 16383. Errors: parity, refused (error flag set by an
  /// earlier command), not_ready (no measurement, overflow, a line stuck at 0), out_of_range
  /// (magnet too near or too far; the angle is returned anyway).
  BusError angle(std::uint16_t& counts) {
    const std::uint16_t angle = big_endian(angle_);
    const std::uint16_t diagnostics = big_endian(diagnostics_);
    if (is_odd(angle) || is_odd(diagnostics)) return BusError::parity;
    clear_ = ((angle | diagnostics) & kErrorFlag) != 0;
    if (clear_) return BusError::refused;
    if ((diagnostics & kMeasures) == 0 || (diagnostics & kOverflow) != 0) {
      return BusError::not_ready;
    }
    counts = angle & kData;
    return (diagnostics & kField) == 0 ? BusError::none : BusError::out_of_range;
  }

 private:
  static constexpr std::uint16_t kNoOperation = 0x0000;
  static constexpr std::uint16_t kRead = 0x4000;
  static constexpr std::uint16_t kErrorFlag = 0x4000;
  static constexpr std::uint16_t kData = 0x3fff;
  static constexpr std::uint16_t kMeasures = 0x0100;
  static constexpr std::uint16_t kOverflow = 0x0200;
  static constexpr std::uint16_t kField = 0x0c00;

  template <class Bus>
  static void transfer(Bus& bus, SpiDevice device, std::uint16_t command, std::uint8_t* answer) {
    const std::uint8_t bytes[2] = {high_byte(command), low_byte(command)};
    bus.spi(device, bytes, answer, 2);
  }

  std::uint8_t angle_[2]{};
  std::uint8_t diagnostics_[2]{};
  bool clear_ = false;
};

}  // namespace eagerx::drivers

// SPI of the MPS2 boards: PrimeCell PL022. Sources: Arm DDI 0194G; DAI 0386, 4.3 and 4.9 (FPGA
// system control registers, the select lines of shields and ADC).
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/common/bare-metal/memory.hpp>

namespace eagerx::board::mps2 {

inline constexpr std::uintptr_t kSpiExternal = 0x40020000;
inline constexpr std::uintptr_t kSpiAdc = 0x40025000;
inline constexpr std::uintptr_t kSpiShield0 = 0x40026000;
inline constexpr std::uintptr_t kSpiShield1 = 0x40027000;

/// A select line: a bit of the FPGA's MISC register that is low while the device is spoken to.
inline constexpr std::uint8_t kSelectAdc = 7;
inline constexpr std::uint8_t kSelectShield0 = 8;
inline constexpr std::uint8_t kSelectShield1 = 9;

/// Words of 8 bits, most significant bit first. `Wait::at_least_ns(n)` keeps a select line high
/// between two transfers. All bytes are zero until start().
template <class Wait, class Memory = MappedMemory>
class Spi {
 public:
  void start(std::uintptr_t base, std::uint32_t clock_hz, std::uint32_t max_hz) {
    base_ = base;
    clock_hz_ = clock_hz;
    max_hz_ = max_hz;
  }

  /// Sends n bytes to the device at `select` and receives as many; `in` may be null. Errors:
  /// unsupported (not started; the clock would be slower than clock_hz/65024), timeout.
  BusError transfer(SpiDevice device, std::uint8_t select, const std::uint8_t* out,
                    std::uint8_t* in, std::size_t n) const {
    if (base_ == 0 || device.mode > 3 || !set(device)) return BusError::unsupported;
    clear_bits<Memory>(kMisc, 1U << select);
    Wait::at_least_ns(kSelectedNs);
    BusError error = BusError::none;
    for (std::size_t i = 0; i < n && error == BusError::none; ++i) {
      std::uint8_t answer = 0;
      error = exchange(out[i], answer);
      if (in != nullptr) in[i] = answer;
    }
    set_bits<Memory>(kMisc, 1U << select);
    Wait::at_least_ns(kHighNs);
    return error;
  }

 private:
  static constexpr std::uintptr_t kMisc = 0x4002804C;
  static constexpr std::uintptr_t kControl0 = 0x00;
  static constexpr std::uintptr_t kControl1 = 0x04;
  static constexpr std::uintptr_t kData = 0x08;
  static constexpr std::uintptr_t kStatus = 0x0c;
  static constexpr std::uintptr_t kPrescaler = 0x10;
  static constexpr std::uint32_t kOn = 1U << 1U;
  static constexpr std::uint32_t kNotFull = 1U << 1U;
  static constexpr std::uint32_t kReceived = 1U << 2U;
  static constexpr std::uint32_t kHighNs = 400;
  static constexpr std::uint32_t kSelectedNs = 400;
  static constexpr std::uint32_t kPatience = 100'000;  // reads of the status

  /// clock_hz / (prescaler · (1 + rate)), prescaler even, 2 to 254, rate 0 to 255.
  bool set(SpiDevice device) const {
    const std::uint32_t limit = device.max_hz < max_hz_ ? device.max_hz : max_hz_;
    constexpr std::uint32_t kLargestPrescaler = 254;
    if (limit == 0) return false;
    std::uint32_t prescaler = 2;
    while (prescaler <= kLargestPrescaler && rate(prescaler, limit) > 0xffU) prescaler += 2;
    if (prescaler > kLargestPrescaler) return false;
    constexpr std::uint32_t kEightBits = 7;
    const std::uint32_t polarity = device.mode >> 1U;
    const std::uint32_t phase = device.mode & 1U;
    Memory::write(base_ + kControl1, 0);
    Memory::write(base_ + kPrescaler, prescaler);
    Memory::write(base_ + kControl0,
                  kEightBits | polarity << 6U | phase << 7U | rate(prescaler, limit) << 8U);
    Memory::write(base_ + kControl1, kOn);
    return true;
  }
  std::uint32_t rate(std::uint32_t prescaler, std::uint32_t limit) const {
    const std::uint32_t divided = clock_hz_ / prescaler;
    return divided <= limit ? 0 : (divided + limit - 1) / limit - 1;
  }

  BusError exchange(std::uint8_t out, std::uint8_t& in) const {
    if (!wait(kNotFull)) return BusError::timeout;
    Memory::write(base_ + kData, out);
    if (!wait(kReceived)) return BusError::timeout;
    in = static_cast<std::uint8_t>(Memory::read(base_ + kData) & 0xffU);
    return BusError::none;
  }
  bool wait(std::uint32_t bit) const {
    for (std::uint32_t i = 0; i < kPatience; ++i) {
      if (has_bits<Memory>(base_ + kStatus, bit)) return true;
    }
    return false;
  }

  std::uintptr_t base_ = 0;
  std::uint32_t clock_hz_ = 0;
  std::uint32_t max_hz_ = 0;
};

}  // namespace eagerx::board::mps2

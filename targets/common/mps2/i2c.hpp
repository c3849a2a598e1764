// I2C of the MPS2 boards: two lines that the program moves itself. Source: Arm DAI 0386, 4.6
// (SBCon).
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/common/bare-metal/memory.hpp>

namespace eagerx::board::mps2 {

inline constexpr std::uintptr_t kI2cTouch = 0x40022000;
inline constexpr std::uintptr_t kI2cAudio = 0x40023000;
inline constexpr std::uintptr_t kI2cShield0 = 0x40029000;
inline constexpr std::uintptr_t kI2cShield1 = 0x4002A000;

/// 100 or 400 kHz at most, as the processor can; 7-bit addresses. Devices may stretch the clock.
/// All bytes are zero until start(). `Wait::at_least_ns(n)` times the edges.
template <class Wait, class Memory = MappedMemory>
class I2c {
 public:
  void start(std::uintptr_t base, std::uint32_t max_hz) {
    base_ = base;
    max_hz_ = max_hz;
    release(kClock | kData);
  }

  /// Writes n bytes, then reads m after a repeated start. Errors: unsupported (not started, slower
  /// than 100 kHz), nak, timeout (the clock is held low).
  BusError transfer(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
                    std::size_t m) {
    const std::uint32_t limit = device.max_hz < max_hz_ ? device.max_hz : max_hz_;
    if (base_ == 0 || limit < kStandardHz) return BusError::unsupported;
    half_ns_ = limit < kFastHz ? 5'000 : 1'250;
    stuck_ = false;
    bool acknowledged = true;
    if (n > 0 || m == 0) acknowledged = write(device.address, out, n);
    if (acknowledged && m > 0) acknowledged = read(device.address, in, m);
    stop();
    if (stuck_) return BusError::timeout;
    return acknowledged ? BusError::none : BusError::nak;
  }

 private:
  static constexpr std::uintptr_t kSet = 0x00;  // reading it gives the levels
  static constexpr std::uintptr_t kClear = 0x04;
  static constexpr std::uint32_t kClock = 1U << 0U;
  static constexpr std::uint32_t kData = 1U << 1U;
  static constexpr std::uint32_t kStandardHz = 100'000;
  static constexpr std::uint32_t kFastHz = 400'000;
  static constexpr std::uint32_t kPatience = 1'000;  // half periods that a clock may be stretched

  void release(std::uint32_t lines) const { Memory::write(base_ + kSet, lines); }
  void pull(std::uint32_t lines) const { Memory::write(base_ + kClear, lines); }
  void half() const { Wait::at_least_ns(half_ns_); }

  bool write(std::uint8_t address, const std::uint8_t* out, std::size_t n) {
    begin();
    bool acknowledged = send(static_cast<std::uint8_t>(address << 1U));
    for (std::size_t i = 0; i < n && acknowledged; ++i) acknowledged = send(out[i]);
    return acknowledged;
  }
  bool read(std::uint8_t address, std::uint8_t* in, std::size_t m) {
    begin();
    if (!send(static_cast<std::uint8_t>(address << 1U | 1U))) return false;
    for (std::size_t i = 0; i < m; ++i) in[i] = receive(i + 1 < m);
    return true;
  }

  /// A start, or a repeated one: the data line falls while the clock is high.
  void begin() {
    release(kData);
    half();
    raise_clock();
    pull(kData);
    half();
    pull(kClock);
  }
  void stop() {
    pull(kData);
    half();
    raise_clock();
    release(kData);
    half();
  }
  bool send(std::uint8_t byte) {
    for (unsigned bit = 8; bit-- > 0;) put((byte >> bit & 1U) != 0);
    return !get();
  }
  std::uint8_t receive(bool acknowledge) {
    unsigned byte = 0;
    for (int bit = 0; bit < 8; ++bit) byte = byte << 1U | (get() ? 1U : 0U);
    put(!acknowledge);
    return static_cast<std::uint8_t>(byte);
  }
  void put(bool level) {
    level ? release(kData) : pull(kData);
    half();
    raise_clock();
    pull(kClock);
  }
  bool get() {
    release(kData);
    half();
    raise_clock();
    const bool level = has_bits<Memory>(base_ + kSet, kData);
    pull(kClock);
    return level;
  }
  void raise_clock() {
    release(kClock);
    half();
    for (std::uint32_t i = 0; !has_bits<Memory>(base_ + kSet, kClock); ++i) {
      if (stuck_ || i == kPatience) {
        stuck_ = true;
        return;
      }
      half();
    }
  }

  std::uintptr_t base_ = 0;
  std::uint32_t max_hz_ = 0;
  std::uint32_t half_ns_ = 0;
  bool stuck_ = false;
};

}  // namespace eagerx::board::mps2

// ADC1 of the STM32F405. Source: ST RM0090, rev 19, chapter 13; pins: DS8626, table 7.
#pragma once

#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/stm32f405/gpio.hpp>

namespace eagerx::board::stm32 {

/// 12 bits, single conversions started by software: 3.3 us each at 21 MHz (56 + 12 clocks).
/// All bytes are zero until start().
template <class Memory = MappedMemory>
class Adc {
 public:
  static constexpr std::uint8_t kChannels = 16;
  static constexpr std::uint32_t kCounts = 4096;

  /// `reference`: voltage at V_REF+.
  void start(float reference) {
    volts_per_count_ = reference / static_cast<float>(kCounts);
    open<Memory>({rcc::kApb2Enable, 8});
    constexpr std::uint32_t kClockBy4 = 1U << 16U;  // 84 MHz / 4; at most 36 (DS8626, table 67)
    change_bits<Memory>(kCommonControl, 3U << 16U, kClockBy4);
    Memory::write(kControl1, 0);   // 12 bits, no scan
    Memory::write(kSequence1, 0);  // one conversion
    Memory::write(kSampleTime1, kAll56 >> 3U);
    Memory::write(kSampleTime2, kAll56);
    Memory::write(kControl2, kOn);
    for (std::uint32_t i = 0; i < kReadsToSettle; ++i) static_cast<void>(Memory::read(kStatus));
  }
  /// The analog pin of channel 0 to 15; kNoPin if there is none.
  static constexpr Pin pin_of_channel(std::uint8_t channel) {
    if (channel < 8) return {0, channel};                                          // PA0 to PA7
    if (channel < 10) return {1, static_cast<std::uint8_t>(channel - 8)};          // PB0, PB1
    if (channel < kChannels) return {2, static_cast<std::uint8_t>(channel - 10)};  // PC0 to PC5
    return kNoPin;
  }
  static bool add(std::uint8_t channel) {
    if (channel >= kChannels) return false;
    Gpio<Memory>::make_analog(pin_of_channel(channel));
    return true;
  }

  /// A conversion, 0 to 4095. Errors: unsupported, timeout.
  BusError sample(std::uint8_t channel, std::uint16_t& counts) const {
    if (channel >= kChannels || volts_per_count_ == 0.0F) return BusError::unsupported;
    Memory::write(kSequence3, channel);
    Memory::write(kStatus, 0);
    Memory::write(kControl2, kOn | kStart);
    for (std::uint32_t i = 0; i < kPatience; ++i) {
      if (!has_bits<Memory>(kStatus, kEndOfConversion)) continue;
      counts = static_cast<std::uint16_t>(Memory::read(kData) & (kCounts - 1));
      return BusError::none;
    }
    return BusError::timeout;
  }
  BusError read_volts(std::uint8_t channel, float& volts) const {
    std::uint16_t counts = 0;
    const BusError error = sample(channel, counts);
    if (error == BusError::none) volts = static_cast<float>(counts) * volts_per_count_;
    return error;
  }

 private:
  static constexpr std::uintptr_t kStatus = 0x40012000;
  static constexpr std::uintptr_t kControl1 = 0x40012004;
  static constexpr std::uintptr_t kControl2 = 0x40012008;
  static constexpr std::uintptr_t kSampleTime1 = 0x4001200C;  // channels 10 to 18
  static constexpr std::uintptr_t kSampleTime2 = 0x40012010;  // channels 0 to 9
  static constexpr std::uintptr_t kSequence1 = 0x4001202C;
  static constexpr std::uintptr_t kSequence3 = 0x40012034;
  static constexpr std::uintptr_t kData = 0x4001204C;
  static constexpr std::uintptr_t kCommonControl = 0x40012304;

  static constexpr std::uint32_t kOn = 1U << 0U;
  static constexpr std::uint32_t kStart = 1U << 30U;
  static constexpr std::uint32_t kEndOfConversion = 1U << 1U;
  static constexpr std::uint32_t kAll56 = 03333333333;  // 3 (56 clocks) for ten channels
  static constexpr std::uint32_t kPatience = 10'000;
  // 3 us (DS8626, table 67), of at least four cycles of 168 MHz each.
  static constexpr std::uint32_t kReadsToSettle = 200;

  float volts_per_count_ = 0.0F;
};

}  // namespace eagerx::board::stm32

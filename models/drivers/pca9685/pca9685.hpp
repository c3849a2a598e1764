// A 16-channel pulse width modulator of NXP on I2C: PCA9685, for motor drivers and hobby servos.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::drivers {

/// 12 bits a channel; every channel switches on at one count of 4096 and off at another. I2C up to
/// 1 MHz. Source: NXP PCA9685 product data sheet rev. 4, sections 7.3.1, 7.3.3 and 7.3.5.
class Pca9685 {
 public:
  static constexpr std::uint8_t kAddress = 0x40;  // plus the six address pins
  static constexpr std::uint32_t kMaxHz = 1'000'000;
  static constexpr std::uint16_t kCounts = 4096;
  static constexpr std::size_t kChannels = 16;

  explicit constexpr Pca9685(std::uint8_t address = kAddress) : address_(address) {}

  /// Divider for a frequency, equation 1: round(25 MHz / (4096·f)) − 1, from 3 (1526 Hz) to 255
  /// (24 Hz).
  static constexpr std::uint8_t prescale(double hz) {
    const double exact = 25e6 / (kCounts * hz) + 0.5;
    if (!(exact >= 4.0)) return 3;
    return exact >= 256.0 ? 255 : static_cast<std::uint8_t>(static_cast<unsigned>(exact) - 1U);
  }

  /// The four registers of a channel (on low, on high, off low, off high): on at `on` counts of the
  /// 4096, for `width` counts; 0 is always off, 4096 and more always on.
  struct Channel {
    std::uint8_t bytes[4];
  };
  static constexpr Channel channel(std::uint16_t on, std::uint16_t width) {
    if (width == 0) return {{0, 0, 0, kFull}};
    if (width >= kCounts) return {{0, kFull, 0, 0}};
    on = static_cast<std::uint16_t>(on % kCounts);  // bit 12 would be `always on`
    const auto off = static_cast<std::uint16_t>((on + width) % kCounts);
    return {{low_byte(on), high_byte(on), low_byte(off), high_byte(off)}};
  }
  /// Counts of a duty cycle from 0 to 1, limited; NaN is 0.
  template <class Real>
  static constexpr std::uint16_t width_of(Real duty) {
    if (!(duty > Real(0))) return 0;
    return duty >= Real(1) ? kCounts : static_cast<std::uint16_t>(duty * kCounts + Real(0.5));
  }

  /// Queues the transfers that set the frequency and switch the oscillator on; channels stay off
  /// until they are written. The oscillator needs 500 µs: wait before the first width.
  template <I2cBus Bus>
  void configure(Bus& bus, double hz) {
    write(bus, kMode1, kSleep | kAutoIncrement, status_[0]);  // PRE_SCALE is open while asleep only
    write(bus, kPreScale, prescale(hz), status_[1]);
    write(bus, kMode1, kAutoIncrement, status_[2]);
    write(bus, kMode2, kTotemPole, status_[3]);
  }
  /// Queues the width of channel `number`, 0 to 15; others are refused.
  template <I2cBus Bus>
  BusError write_channel(Bus& bus, std::size_t number, Channel channel) {
    if (number >= kChannels) return BusError::out_of_range;
    const auto reg = static_cast<std::uint8_t>(kChannel0 + 4 * number);
    const std::uint8_t bytes[5] = {reg, channel.bytes[0], channel.bytes[1], channel.bytes[2],
                                   channel.bytes[3]};
    bus.i2c({address_, kMaxHz}, bytes, sizeof bytes, nullptr, 0, status_[4]);
    return BusError::none;
  }
  /// Queues a transfer that switches all channels off.
  template <I2cBus Bus>
  void all_off(Bus& bus) {
    const std::uint8_t bytes[5] = {kAllChannels, 0, 0, 0, kFull};
    bus.i2c({address_, kMaxHz}, bytes, sizeof bytes, nullptr, 0, status_[4]);
  }
  /// After run(): the first error since configure(), for each transfer its latest.
  BusError status() const {
    for (const BusError error : status_) {
      if (error != BusError::none) return error;
    }
    return BusError::none;
  }

 private:
  static constexpr std::uint8_t kMode1 = 0x00;
  static constexpr std::uint8_t kMode2 = 0x01;
  static constexpr std::uint8_t kChannel0 = 0x06;
  static constexpr std::uint8_t kAllChannels = 0xfa;
  static constexpr std::uint8_t kPreScale = 0xfe;
  static constexpr std::uint8_t kAutoIncrement = 0x20;
  static constexpr std::uint8_t kSleep = 0x10;
  static constexpr std::uint8_t kTotemPole = 0x04;
  static constexpr std::uint8_t kFull = 0x10;

  template <class Bus>
  void write(Bus& bus, std::uint8_t reg, std::uint8_t value, BusError& status) {
    const std::uint8_t bytes[2] = {reg, value};
    bus.i2c({address_, kMaxHz}, bytes, 2, nullptr, 0, status);
  }

  std::uint8_t address_;
  BusError status_[5]{};
};

}  // namespace eagerx::drivers

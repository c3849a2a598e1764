// The peripherals of the STM32F405 that one program uses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/stm32f405/adc.hpp>
#include <targets/stm32f405/encoder.hpp>
#include <targets/stm32f405/i2c.hpp>
#include <targets/stm32f405/pwm.hpp>
#include <targets/stm32f405/spi.hpp>
#include <targets/stm32f405/watchdog.hpp>

namespace eagerx::board::stm32 {

/// For ImmediateLink: one SPI with select lines, one I2C, pins, PWM outputs, ADC inputs and
/// encoders by number. A peripheral that was not started is unsupported. All bytes are zero until
/// start().
template <class Wait, class Memory = MappedMemory>
class Hardware {
 public:
  static constexpr std::size_t kMostPins = 8;
  static constexpr std::size_t kMostEncoders = 4;

  bool start_spi(const SpiPort& port, const SpiPins& pins, std::uint32_t max_hz) {
    return spi_.start(port, pins, max_hz);
  }
  /// The next select line; false if there are 8.
  bool add_select(Pin pin) {
    if (selects_ == kMostPins || pin == kNoPin) return false;
    Spi<Wait, Memory>::add_select(pin);
    select_[selects_++] = pin;
    return true;
  }
  bool start_i2c(const I2cPort& port, const I2cPins& pins, std::uint32_t max_hz) {
    return i2c_.start(port, pins, max_hz);
  }
  /// The next pin of write_pin() and read_pin(): an input with a pull-up until it is written.
  bool add_pin(Pin pin) {
    if (pins_ == kMostPins || pin == kNoPin) return false;
    Gpio<Memory>::make_input(pin, PinPull::up);
    pin_[pins_++] = pin;
    return true;
  }
  /// PWM channels 0 to `channels` - 1 on the pins of a timer.
  bool start_pwm(const TimerPort& port, std::uint32_t hz, std::uint8_t channels) {
    if (!pwm_.start(port, hz)) return false;
    for (std::uint8_t i = 0; i < channels; ++i) {
      if (!pwm_.add(i)) return false;
    }
    return true;
  }
  bool start_adc(float reference) { return adc_.start(reference), true; }
  /// The chip's channel that is the next number of read_volts(); false if there are 8.
  bool add_adc(std::uint8_t channel) {
    if (voltages_ == kMostPins || !Adc<Memory>::add(channel)) return false;
    voltage_[voltages_++] = channel;
    return true;
  }
  /// The next encoder; false if there are 4.
  bool add_encoder(const TimerPort& port) {
    if (encoders_ == kMostEncoders) return false;
    encoder_[encoders_++].start(port);
    return true;
  }

  bool start_watchdog(std::uint32_t ms) {
    is_watched_ = IndependentWatchdog<Memory>::start(ms);
    return is_watched_;
  }
  /// Called by every run() of the link.
  void feed() {
    if (is_watched_) IndependentWatchdog<Memory>::feed();
  }

  BusError spi(SpiDevice device, const std::uint8_t* out, std::uint8_t* in, std::size_t n) {
    if (device.select >= selects_) return BusError::unsupported;
    return spi_.transfer(device, select_[device.select], out, in, n);
  }
  BusError i2c(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
               std::size_t m) {
    return i2c_.transfer(device, out, n, in, m);
  }
  BusError write_pin(std::uint8_t pin, bool level) {
    if (pin >= pins_) return BusError::unsupported;
    if (is_output_[pin]) {
      Gpio<Memory>::write(pin_[pin], level);
    } else {
      Gpio<Memory>::make_output(pin_[pin], level);
    }
    is_output_[pin] = true;
    return BusError::none;
  }
  BusError read_pin(std::uint8_t pin, bool& level) {
    if (pin >= pins_) return BusError::unsupported;
    level = Gpio<Memory>::read(pin_[pin]);
    return BusError::none;
  }
  BusError write_duty(std::uint8_t channel, float duty) { return pwm_.write_duty(channel, duty); }
  BusError read_volts(std::uint8_t channel, float& volts) {
    if (channel >= voltages_) return BusError::unsupported;
    return adc_.read_volts(voltage_[channel], volts);
  }
  BusError read_encoder(std::uint8_t encoder, std::int32_t& counts) {
    if (encoder >= encoders_) return BusError::unsupported;
    return encoder_[encoder].read(counts);
  }

 private:
  Spi<Wait, Memory> spi_{};
  I2c<Wait, Memory> i2c_{};
  Pwm<Memory> pwm_{};
  Adc<Memory> adc_{};
  std::array<Encoder<Memory>, kMostEncoders> encoder_{};
  std::array<Pin, kMostPins> select_{};
  std::array<Pin, kMostPins> pin_{};
  std::array<bool, kMostPins> is_output_{};
  std::array<std::uint8_t, kMostPins> voltage_{};
  bool is_watched_ = false;
  std::size_t selects_ = 0;
  std::size_t pins_ = 0;
  std::size_t voltages_ = 0;
  std::size_t encoders_ = 0;
};

}  // namespace eagerx::board::stm32

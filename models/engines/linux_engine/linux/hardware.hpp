// The buses and pins of a Linux system that one program uses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <models/links/linux/gpio.hpp>
#include <models/links/linux/i2c.hpp>
#include <models/links/linux/spi.hpp>
#include <models/links/linux/sysfs.hpp>
#include <models/links/linux/watchdog.hpp>
#include <string_view>

namespace eagerx::models {

/// For ImmediateLink. Every add…() takes the next number of its kind, whether its device can be
/// opened or not; false if it cannot, or if there are too many. All bytes are zero at first.
template <class System = links::Kernel>
class LinuxHardware {
 public:
  static constexpr std::size_t kMost = 8;
  static constexpr std::size_t kMostEncoders = 4;

  bool add_spi(std::string_view path, std::uint32_t max_hz) {
    return selects_ < kMost && spi_[selects_++].open(links::Path(path).text(), max_hz);
  }
  bool open_i2c(const char* path) { return i2c_.open(path); }
  bool add_pin(const char* chip, std::uint32_t line) {
    return pins_ < kMost && pin_[pins_++].open(chip, line);
  }
  bool add_pwm(std::string_view chip, unsigned output, std::uint32_t hz) {
    return pwms_ < kMost && pwm_[pwms_++].open(chip, output, hz);
  }
  bool add_adc(std::string_view device, unsigned voltage) {
    return adcs_ < kMost && adc_[adcs_++].open(device, voltage);
  }
  bool add_encoder(std::string_view folder) {
    return encoders_ < kMostEncoders && encoder_[encoders_++].open(folder);
  }
  bool open_watchdog(const char* path, std::uint32_t ms) {
    if (watchdog_.open(path) && watchdog_.start(ms)) return true;
    watchdog_.close();
    return false;
  }

  BusError spi(SpiDevice device, const std::uint8_t* out, std::uint8_t* in, std::size_t n) {
    if (device.select >= selects_) return BusError::unsupported;
    return spi_[device.select].transfer(device, out, in, n);
  }
  BusError i2c(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
               std::size_t m) {
    return i2c_.transfer(device, out, n, in, m);
  }
  BusError write_pin(std::uint8_t pin, bool level) {
    return pin < pins_ ? pin_[pin].write(level) : BusError::unsupported;
  }
  BusError read_pin(std::uint8_t pin, bool& level) {
    return pin < pins_ ? pin_[pin].read(level) : BusError::unsupported;
  }
  BusError write_duty(std::uint8_t channel, float duty) {
    return channel < pwms_ ? pwm_[channel].write_duty(duty) : BusError::unsupported;
  }
  BusError read_volts(std::uint8_t channel, float& volts) {
    return channel < adcs_ ? adc_[channel].read_volts(volts) : BusError::unsupported;
  }
  BusError read_encoder(std::uint8_t encoder, std::int32_t& counts) {
    return encoder < encoders_ ? encoder_[encoder].read(counts) : BusError::unsupported;
  }
  void feed() { watchdog_.feed(); }

  void close() {
    for (auto& each : spi_) each.close();
    i2c_.close();
    for (auto& each : pin_) each.close();
    for (auto& each : pwm_) each.close();
    for (auto& each : adc_) each.close();
    for (auto& each : encoder_) each.close();
    watchdog_.close();
  }

 private:
  std::array<links::LinuxSpi<System>, kMost> spi_{};
  links::LinuxI2c<System> i2c_{};
  std::array<links::LinuxPin<System>, kMost> pin_{};
  std::array<links::LinuxPwm, kMost> pwm_{};
  std::array<links::LinuxAdc, kMost> adc_{};
  std::array<links::LinuxEncoder, kMostEncoders> encoder_{};
  links::LinuxWatchdog<System> watchdog_{};
  std::size_t selects_ = 0;
  std::size_t pins_ = 0;
  std::size_t pwms_ = 0;
  std::size_t adcs_ = 0;
  std::size_t encoders_ = 0;
};

}  // namespace eagerx::models

// A bus that carries out every transfer at once: that of a board, or of a Linux system's own pins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::links {

/// A bus (SpiBus, I2cBus, GpioBus, PwmBus, AdcBus, EncoderBus, as far as `Hardware` has them) out
/// of functions that carry one thing out and return a BusError:
///   spi(SpiDevice, out, in, n)   i2c(I2cDevice, out, n, in, m)
///   write_pin(pin, level)   read_pin(pin, level&)   write_duty(channel, duty)
///   read_volts(channel, volts&)   read_encoder(encoder, counts&)   close()   feed(), of a watchdog
/// After an error the other transfers of the same run() are still carried out, because they may
/// make another device safe. run() returns the first error. All bytes are zero until open.
template <class HardwareType, class ClockType>
class ImmediateLink {
 public:
  using Clock = ClockType;
  using Hardware = HardwareType;

  Hardware& hardware() { return hardware_; }
  void close() {
    if constexpr (requires { hardware_.close(); }) hardware_.close();
  }

  void spi(SpiDevice device, const std::uint8_t* out, std::uint8_t* in, std::size_t n) requires
      requires(Hardware& hardware) {
    hardware.spi(device, out, in, n);
  }
  { keep(hardware_.spi(device, out, in, n)); }
  void i2c(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
           std::size_t m, BusError& status) requires requires(Hardware& hardware) {
    hardware.i2c(device, out, n, in, m);
  }
  {
    status = hardware_.i2c(device, out, n, in, m);
    if (status != BusError::nak) keep(status);  // a missing device is not an error of the bus
  }
  void write_pin(std::uint8_t pin, bool level) requires requires(Hardware& hardware) {
    hardware.write_pin(pin, level);
  }
  { keep(hardware_.write_pin(pin, level)); }
  void read_pin(std::uint8_t pin, bool& level) requires requires(Hardware& hardware) {
    hardware.read_pin(pin, level);
  }
  { keep(hardware_.read_pin(pin, level)); }
  void write_duty(std::uint8_t channel, float duty) requires requires(Hardware& hardware) {
    hardware.write_duty(channel, duty);
  }
  { keep(hardware_.write_duty(channel, duty)); }
  void read_volts(std::uint8_t channel, float& volts) requires requires(Hardware& hardware) {
    hardware.read_volts(channel, volts);
  }
  { keep(hardware_.read_volts(channel, volts)); }
  void read_encoder(std::uint8_t encoder, std::int32_t& counts) requires
      requires(Hardware& hardware) {
    hardware.read_encoder(encoder, counts);
  }
  { keep(hardware_.read_encoder(encoder, counts)); }

  /// Everything is carried out already: the first error since the last call.
  BusError run() {
    if constexpr (requires { hardware_.feed(); }) hardware_.feed();
    const BusError error = error_;
    error_ = BusError::none;
    if (error != BusError::none) ++errors_[static_cast<std::size_t>(error)];
    return error;
  }
  /// The same as run(), because there is nothing to wait for.
  BusError post() { return run(); }

  /// Calls f(name, count) for each count.
  template <class F>
  void for_each_count(F&& f) const {
    f("bus unsupported", count(BusError::unsupported));
    f("bus lost", count(BusError::link_lost));
    f("bus timeouts", count(BusError::timeout));
    f("bus out of range", count(BusError::out_of_range));
  }

 private:
  void keep(BusError error) {
    if (error_ == BusError::none) error_ = error;
  }
  std::uint64_t count(BusError error) const { return errors_[static_cast<std::size_t>(error)]; }

  Hardware hardware_{};
  BusError error_ = BusError::none;
  std::uint64_t errors_[kBusErrors]{};
};

}  // namespace eagerx::links

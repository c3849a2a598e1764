// A brushed DC motor at PWM outputs, a quadrature encoder and an ADC.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/message.hpp>
#include <eagerx/peripheral.hpp>
#include <numbers>

namespace eagerx::models {

/// Wiring: encoder 0 on the shaft; PWM channels 0 and 1 to the inputs of a bridge (positive voltage
/// modulates 0, negative 1, the other is low); ADC channel 0 measures the bridge's current.
/// Sensors [θ in rad, 0 at the start; ω in rad/s; current in A], actuator [u in V].
template <class Io>
class DcMotorReal {
 public:
  using Real = typename Io::Real;
  static constexpr std::size_t kSensors = 3;
  static constexpr std::size_t kActuators = 1;

  void reset() {}

  template <class Bus>
  void request(Bus& bus) {
    static_assert(PwmBus<Bus> && AdcBus<Bus> && EncoderBus<Bus>,
                  "DcMotor: this engine has no PWM, ADC and encoders; LinuxEngine and "
                  "Stm32F405Engine have");
    bus.read_encoder(0, counts_);
    bus.read_volts(0, volts_);
  }

  BusError measure(std::int64_t now_ns, Array<Real, kSensors>& values) {
    constexpr auto kPerCount =
        Real(2) * std::numbers::pi_v<Real> / static_cast<Real>(Io::Config::counts_per_turn);
    const std::int64_t period_ns = now_ns - at_ns_;
    if (at_ns_ == 0) before_ = counts_;
    const auto moved = difference(counts_, before_);
    total_ += moved;
    if (at_ns_ != 0 && period_ns > 0) {
      const Real period = static_cast<Real>(period_ns) * Real(1e-9);
      omega_ = static_cast<Real>(moved) * kPerCount / period;
    }
    before_ = counts_;
    at_ns_ = now_ns;
    values = {{static_cast<Real>(total_) * kPerCount, omega_,
               static_cast<Real>(volts_) / static_cast<Real>(Io::Config::volts_per_ampere)}};
    return BusError::none;
  }

  template <class Bus>
  void act(Bus& bus, const Array<Real, kActuators>& action) {
    const auto duty = static_cast<float>(action[0] / static_cast<Real>(Io::Config::supply));
    // The one that becomes low first: never are both high.
    bus.write_duty(duty > 0.0F ? 1 : 0, 0.0F);
    bus.write_duty(duty > 0.0F ? 0 : 1, duty > 0.0F ? duty : -duty);
  }

 private:
  /// Of counts that wrap.
  static constexpr std::int32_t difference(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
  }

  std::int64_t total_ = 0;  // counts
  std::int64_t at_ns_ = 0;
  std::int32_t counts_ = 0;
  std::int32_t before_ = 0;
  float volts_ = 0.0F;
  Real omega_{};
};

}  // namespace eagerx::models

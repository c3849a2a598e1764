// The real disc pendulum: encoder and motor amplifier.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <models/drivers/as5048/as5048.hpp>
#include <models/drivers/mcp4921/mcp4921.hpp>
#include <models/engines/ode_engine/ode_model.hpp>
#include <models/engines/ode_engine/rk4.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>
#include <models/processors/normalize_angle/normalize_angle.hpp>
#include <numbers>

namespace eagerx::models {

/// Wiring:
///   select line 0  AS5048A on the shaft, counting as θ does, 0 upright (set its zero position)
///   select line 1  MCP4921 with a reference of 4.096 V; amplifier: motor voltage u = V_out − 2.048
///   V
/// Sensors [θ in rad, not wrapped; ω in rad/s], actuator [u in V, −2.048 to 2.047].
///
/// θ is what the encoder says. ω comes from an observer: the pendulum's equations (PendulumOde, its
/// nominal parameters, the voltage that was sent) from sample to sample, corrected by the angle,
///   θ̂ += (1 − λ²)·(θ − θ̂),   ω̂ += (1 − λ)²/T·(θ − θ̂),   λ = e^(−T/τ), T the measured period, τ =
///   20 ms
/// which is an α-β filter around the model with a double pole at λ. After more than 0.2 s without a
/// sample it begins anew, with ω̂ = 0.
template <class Io>
class PendulumReal {
 public:
  using Real = typename Io::Real;
  static constexpr std::size_t kSensors = 2;
  static constexpr std::size_t kActuators = 1;

  void reset() { wraps_ = true; }

  template <class Bus>
  void request(Bus& bus) {
    encoder_.request(bus, kEncoder);
  }

  BusError measure(std::int64_t now_ns, Array<Real, kSensors>& values) {
    std::uint16_t counts = 0;
    const BusError error = encoder_.angle(counts);
    if (error != BusError::none) return error;
    constexpr auto kTurn = Real(2) * std::numbers::pi_v<Real>;
    constexpr auto kPerCount = kTurn / Real(Encoder::kCountsPerTurn);
    observe(normalized_angle(static_cast<Real>(counts) * kPerCount), now_ns);
    values = {{theta_, state_[1]}};
    return BusError::none;
  }

  template <class Bus>
  void act(Bus& bus, const Array<Real, kActuators>& action) {
    const std::uint16_t code = drivers::Mcp4921::code_of(action[0] + kMiddle, kReference);
    drivers::Mcp4921::write(bus, kConverter, code);
    volts_ = static_cast<Real>(code) * (kReference / Real(4096)) - kMiddle;
  }

 private:
  using Encoder = drivers::MagneticEncoder<drivers::As5048A>;
  using Ode = PendulumOde<Io>;
  static constexpr std::uint8_t kEncoder = 0;
  static constexpr std::uint8_t kConverter = 1;
  static constexpr auto kReference = Real(4.096);  // [V]
  static constexpr auto kMiddle = Real(2.048);     // [V]
  static constexpr auto kTau = Real(0.02);         // [s]

  /// `angle` within ±π.
  void observe(Real angle, std::int64_t now_ns) {
    constexpr std::int64_t kTooLongNs = 200'000'000;
    const std::int64_t period_ns = now_ns - at_ns_;
    const bool known = at_ns_ != 0 && period_ns > 0 && period_ns < kTooLongNs;
    at_ns_ = now_ns;
    if (wraps_) {  // an episode begins: within ±π, and the observer continues from there
      const Real turns = angle - (theta_ + normalized_angle(angle - theta_));
      state_[0] += turns;
      theta_ = angle;
      wraps_ = false;
    } else {
      theta_ += normalized_angle(angle - theta_);
    }
    if (!known) {
      state_ = {{theta_, Real(0)}};
      return;
    }
    const Real period = static_cast<Real>(period_ns) * Real(1e-9);
    predict(period_ns, period);
    const Real lambda = eagerx::exp(-period / kTau);
    const Real error = theta_ - state_[0];
    state_[0] += (Real(1) - lambda * lambda) * error;
    state_[1] += (Real(1) - lambda) * (Real(1) - lambda) / period * error;
  }

  void predict(std::int64_t period_ns, Real period) {
    constexpr std::int64_t kLongestNs = 1'500'000;  // RK4 is stable up to about 4 ms
    const std::int64_t steps = period_ns / kLongestNs + 1;
    const Real step = period / static_cast<Real>(steps);
    const OdeDerivative<Ode> derivative(Ode::default_parameters(), {{volts_}});
    for (std::int64_t i = 0; i < steps; ++i) state_ = rk4_step(derivative, state_, step);
  }

  Encoder encoder_{};
  typename Ode::State state_{};  // the observer's [θ̂, ω̂]
  Real theta_{};
  Real volts_{};  // as it was sent last
  std::int64_t at_ns_ = 0;
  bool wraps_ = false;
};

}  // namespace eagerx::models

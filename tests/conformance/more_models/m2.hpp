// Shared by the sensors and actuators of M2Object: k are integers, f float32 [2, 3].
#pragma once

#include <cmath>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <tests/conformance/models/fold.hpp>

namespace oracle {

/// The checksum `h` after the engine's tick.
constexpr std::int64_t fold_tick(std::int64_t h) {
  return (h * kBase + 2) % kModulus;
}

/// The checksum `h` after a window; of a float counts sixteen times its value.
template <class Window>
std::int64_t fold_window(const Window& window, std::int64_t h) {
  constexpr double kSteps = 16.0;
  h = (h * kBase + window.size() + 1) % kModulus;
  for (std::uint32_t i = 0; i < window.size(); ++i) {
    const auto& message = window[i];
    for (std::size_t e = 0; e < eagerx::size_of<std::remove_cvref_t<decltype(message)>>; ++e) {
      const auto value = eagerx::element(message, e);
      std::int64_t digits = 0;
      if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(value)>>)
        digits = std::llround(static_cast<double>(value) * kSteps);
      else
        digits = value;
      h = ((h * kBase + digits) % kModulus + kModulus) % kModulus;
    }
  }
  return h;
}

/// The message of a checksum: an integer, or floats in eighths.
template <class Message>
void set_message(Message& message, std::int64_t h) {
  constexpr std::int64_t kFactor = 31, kStep = 37, kRange = 1999, kMiddle = 999;
  constexpr float kEighths = 8.0F;
  for (std::size_t e = 0; e < eagerx::size_of<Message>; ++e) {
    if constexpr (std::is_floating_point_v<eagerx::ScalarOf<Message>>) {
      const std::int64_t number = (h + kStep * static_cast<std::int64_t>(e)) % kRange - kMiddle;
      eagerx::element(message, e) = static_cast<float>(number) / kEighths;
    } else {
      eagerx::element(message, e) = h * kFactor % kModulus;
    }
  }
}

/// Both states of the object, in one checksum.
template <class Io>
class M2Sensor {
 public:
  void reset(const typename Io::States& /*states*/, typename Io::Simulator& /*simulator*/) {}

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& /*in*/,
                typename Io::Outputs& out, typename Io::Simulator& simulator) {
    constexpr std::int64_t kSecond = 3;
    const std::int64_t h =
        fold_tick((simulator.state[0] + kSecond * simulator.state[1]) % kModulus);
    if constexpr (requires { out.ok; })
      set_message(out.ok, h + Io::Config::nid);
    else
      set_message(out.of, h + Io::Config::nid);
  }
};

/// Sets input `index` of the object to the checksum of its window times `gain`, a state like the
/// delay of the window.
template <class Io, std::size_t Index>
class M2Actuator {
 public:
  void reset(const typename Io::States& states, const typename Io::Delays& delays,
             typename Io::Simulator& simulator) {
    simulator.inputs[Index] = 0;
    if (states.gain) gain_ = *states.gain;
    if (!states.delay) return;
    if constexpr (requires { delays.k; })
      delays.k = static_cast<double>(*states.delay);
    else
      delays.f = static_cast<double>(*states.delay);
  }

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out, typename Io::Simulator& simulator) {
    if constexpr (requires { in.k; })
      set(in.k, out.ok, simulator);
    else
      set(in.f, out.of, simulator);
  }

 private:
  void set(const auto& window, auto& out, typename Io::Simulator& simulator) {
    const std::int64_t h = fold_window(window, fold_tick(0)) * gain_ % kModulus;
    simulator.inputs[Index] = h;
    set_message(out, h + Io::Config::nid);
  }

  std::int64_t gain_ = 1;
};

template <class Io>
using M2ActuatorK = M2Actuator<Io, 0>;
template <class Io>
using M2ActuatorF = M2Actuator<Io, 1>;

}  // namespace oracle

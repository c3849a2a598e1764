// Peripherals other than buses: the interfaces of PWM, ADC, quadrature encoders, timers and
// watchdogs for drivers and main programs, the same on every board. Errors are those of bus.hpp,
// and readings are valid after run(), as on a bus.
#pragma once

#include <concepts>
#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx {

/// write_duty(channel, duty): the share of time, 0 to 1, that an output is high. Other values are
/// clamped; NaN is 0.
template <class B>
concept PwmBus = requires(B& bus, std::uint8_t channel, float duty) {
  bus.write_duty(channel, duty);
  { bus.run() } -> std::same_as<BusError>;
};

/// read_volts(channel, volts&): a voltage.
template <class B>
concept AdcBus = requires(B& bus, std::uint8_t channel, float& volts) {
  bus.read_volts(channel, volts);
  { bus.run() } -> std::same_as<BusError>;
};

/// read_encoder(encoder, counts&): edges of both lines since the start, up minus down. Wraps at 32
/// bits.
template <class B>
concept EncoderBus = requires(B& bus, std::uint8_t encoder, std::int32_t& counts) {
  bus.read_encoder(encoder, counts);
  { bus.run() } -> std::same_as<BusError>;
};

/// Time in hardware ticks since the start, in 64 bits; wait_for() returns after the given number of
/// ticks.
template <class T>
concept HardwareTimer = requires(T& timer, std::uint64_t ticks) {
  { timer.ticks() } -> std::same_as<std::uint64_t>;
  { timer.hz() } -> std::convertible_to<std::uint64_t>;
  timer.wait_for(ticks);
};

/// After start(ms), the hardware resets the system if feed() is not called for `ms`. start()
/// returns false if there is no watchdog, or if `ms` is too long for it. Most watchdogs cannot be
/// stopped.
template <class W>
concept Watchdog = requires(W& watchdog, std::uint32_t ms) {
  { watchdog.start(ms) } -> std::same_as<bool>;
  watchdog.feed();
};

/// `duty` as a number of `counts`, rounded to the nearest.
constexpr std::uint32_t counts_of_duty(float duty, std::uint32_t counts) {
  if (!(duty > 0.0F)) return 0;
  if (duty >= 1.0F) return counts;
  const float exact = duty * static_cast<float>(counts);
  const auto whole = static_cast<std::uint32_t>(exact);
  return whole + (exact - static_cast<float>(whole) >= 0.5F ? 1U : 0U);
}

/// Extends a 16-bit counter to 32 bits, for an encoder that is read at least once in 32767 counts.
class WideCount {
 public:
  std::int32_t update(std::uint16_t counter) {
    const auto moved = static_cast<std::uint16_t>(counter - (count_ & 0xffffU));
    count_ += moved < kHalf ? moved : moved - kRound;
    return static_cast<std::int32_t>(count_);
  }

 private:
  static constexpr std::uint32_t kHalf = 0x8000;
  static constexpr std::uint32_t kRound = 0x10000;

  std::uint32_t count_ = 0;  // wraps on purpose
};

}  // namespace eagerx

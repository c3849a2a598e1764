// A random push at the reset of a real object.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/message.hpp>
#include <eagerx/random.hpp>

namespace eagerx::models {

/// At a reset: a random action for `action_time` s, then `rest_action` for `sleep_time` s. An error
/// of the link, or sensors without a value as often in a row as the engine bears, end it with the
/// safe action (at the very first reset with `rest_action`). Source: eagerx_dcsc_setups,
/// pendulum/real/engine_states.py.
template <class Io>
struct RandomActionAndSleep {
  using Simulator = typename Io::Simulator;
  using Real = typename Simulator::Real;

  static void reset(const typename Io::State& value, Simulator& simulator) {
    Random random(EpisodeKey{seed_of(value), 0, 0}, entity_id("RandomActionAndSleep"));
    Real push[kActuators]{};
    for (std::size_t i = 0; i < kActuators; ++i) {
      push[i] = random.uniform(low(i), high(i));
    }
    if (!hold(simulator, push, Io::Config::action_time)) return;
    for (std::size_t i = 0; i < kActuators; ++i) {
      push[i] = static_cast<Real>(Io::Config::rest_action[i]);
    }
    hold(simulator, push, Io::Config::sleep_time);
  }

 private:
  static constexpr std::size_t kActuators = Simulator::Model::kActuators;
  static_assert(Io::Config::low.size() == kActuators && Io::Config::high.size() == kActuators &&
                    Io::Config::rest_action.size() == kActuators,
                "RandomActionAndSleep: `low`, `high` and `rest_action` have one value for each of "
                "the model's actuators");

  static constexpr Real low(std::size_t i) { return static_cast<Real>(Io::Config::low[i]); }
  static constexpr Real high(std::size_t i) { return static_cast<Real>(Io::Config::high[i]); }

  static std::uint64_t seed_of(const typename Io::State& value) {
    std::uint64_t seed = 0;
    for (std::size_t i = 0; i < size_of<typename Io::State>; ++i) {
      constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15U;
      const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(element(value, i)));
      seed = (seed ^ bits) * kOdd;
    }
    return seed;
  }

  static void rest_at_once(Simulator& simulator) {
    for (std::size_t i = 0; i < kActuators; ++i)
      simulator.act(i, static_cast<Real>(Io::Config::rest_action[i]), low(i), high(i));
    simulator.make_safe();
  }

  /// On a system with signals.
  template <class Clock>
  static bool is_interrupted() {
    if constexpr (requires { Clock::is_interrupted(); }) {
      return Clock::is_interrupted();
    } else {
      return false;
    }
  }

  /// False if a signal came or something was wrong.
  static bool hold(Simulator& simulator, const Real (&action)[kActuators], double seconds) {
    using Clock = typename Simulator::Clock;
    constexpr std::int64_t kPeriodNs = 10'000'000;
    const auto end = static_cast<std::int64_t>(seconds * 1e9);
    const std::int64_t start = Clock::now_ns();
    for (std::int64_t at = 0; at < end; at += kPeriodNs) {
      for (std::size_t i = 0; i < kActuators; ++i) simulator.act(i, action[i], low(i), high(i));
      if (simulator.exchange() != BusError::none || simulator.is_stale())
        return rest_at_once(simulator), false;
      if (!Clock::sleep_until(start + at + kPeriodNs) || is_interrupted<Clock>())
        return rest_at_once(simulator), false;
      if (Clock::now_ns() > start + at + 2 * kPeriodNs) {
        simulator.note_late();
        at = Clock::now_ns() - start - kPeriodNs;
      }
    }
    return true;
  }
};

}  // namespace eagerx::models

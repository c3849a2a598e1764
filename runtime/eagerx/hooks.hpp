// Hooks of a generated program, the template parameter `Hooks` of Program: an object that sees
// messages and decides whether the engine runs, slots wait and pictures are drawn. Only
// on_episode() and on_message() are mandatory.
#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

namespace eagerx {

/// Hooks that see the inputs of every callback have `static constexpr bool kSeesInputs = true`,
/// `on_inputs(const char* node, Rate<...> rate, Seq tick, const Inputs& inputs)`, where `rate` is
/// the node's and `inputs.for_each(f)` calls f(name, window) for each, and
/// `on_reset_phase(bool begins)`. The engine has no inputs and is not among them.
template <class Hooks>
inline constexpr bool sees_inputs = requires {
  requires Hooks::kSeesInputs;
};

/// Hooks that see the objects have `static constexpr bool kSeesSimulators = true` and
/// `on_simulator(const char* object, Seq tick, Simulator& simulator)`, which is called at every
/// tick of the engine, before anything reads it; at tick 0 it may set the state that the episode
/// begins in.
template <class Hooks>
inline constexpr bool sees_simulators = requires {
  requires Hooks::kSeesSimulators;
};

/// Hooks that hold slots to real time have `static constexpr bool kWaitsForSlots = true`,
/// `wait_for_slot(Rate<...> rate, Seq tick)`, which is called before anything of a slot is
/// calculated, once for every rate that is due; tick/rate is the same for all of them: when the
/// slot should begin; and `stand_still(Rate<...> rate)`, for a step in which no node runs.
template <class Hooks>
inline constexpr bool waits_for_slots = requires {
  requires Hooks::kWaitsForSlots;
};

/// Hooks that can take the engine's place, because they know what the engine nodes would publish,
/// have `bool runs_engine() const`; while that is false, engine and engine states are not called.
template <class Hooks>
constexpr bool runs_engine(const Hooks& hooks) {
  if constexpr (requires { hooks.runs_engine(); }) {
    return hooks.runs_engine();
  } else {
    return static_cast<void>(hooks), true;
  }
}

/// Hooks that know when the run should end have `bool is_interrupted() const`: a reset that waits
/// for something waits no longer, so that the run's end can make a robot safe.
template <class Hooks>
constexpr bool is_interrupted(const Hooks& hooks) {
  if constexpr (requires { hooks.is_interrupted(); }) {
    return hooks.is_interrupted();
  } else {
    return static_cast<void>(hooks), false;
  }
}

/// Costs nothing.
struct NoHooks {
  void on_episode(std::uint32_t /*index*/) {}
  template <class Message>
  void on_message(std::uint32_t /*channel*/, Seq /*seq*/, const Message& /*message*/) {}
};

}  // namespace eagerx

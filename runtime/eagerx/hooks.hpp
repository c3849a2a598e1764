// Hooks of a generated program, the template parameter `Hooks` of Program: an object that sees
// messages and decides whether the engine runs, slots wait and pictures are drawn. Only
// on_episode() and on_message() are mandatory.
#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

namespace eagerx {

/// Hooks that observe the inputs of every callback have `static constexpr bool kSeesInputs = true`,
/// `on_inputs(const char* node, Rate<...> rate, Seq tick, const Inputs& inputs)`, where `rate` is
/// the node's and `inputs.for_each(f)` calls f(name, window) for each, and `on_reset_phase(bool
/// begins)`. The engine has no inputs and is not among them.
template <class Hooks>
inline constexpr bool sees_inputs = requires {
  requires Hooks::kSeesInputs;
};

/// Hooks that access objects have `static constexpr bool kSeesSimulators = true` and
/// `on_simulator(const char* object, Seq tick, Simulator& simulator)`, which is called at every
/// tick of the engine, before anything reads the simulator; at tick 0 it may set the initial state
/// of the episode.
template <class Hooks>
inline constexpr bool sees_simulators = requires {
  requires Hooks::kSeesSimulators;
};

/// Hooks that hold slots to real time have `static constexpr bool kWaitsForSlots = true`,
/// `wait_for_slot(Rate<...> rate, Seq tick)`, which is called before a slot computes anything, once
/// for every rate that is due, where tick/rate, the same for all of them, is the time of the slot;
/// and `stand_still(Rate<...> rate)`, for a step in which no node runs.
template <class Hooks>
inline constexpr bool waits_for_slots = requires {
  requires Hooks::kWaitsForSlots;
};

/// Hooks that can replace the engine, because they know the messages of the engine nodes, have
/// `bool runs_engine() const`; while it returns false, engine and engine states are not called.
template <class Hooks>
constexpr bool runs_engine(const Hooks& hooks) {
  if constexpr (requires { hooks.runs_engine(); }) {
    return hooks.runs_engine();
  } else {
    return static_cast<void>(hooks), true;
  }
}

/// Hooks that know when the run should end have `bool is_interrupted() const`: a reset then stops
/// waiting, so that the end of the run can make a robot safe.
template <class Hooks>
constexpr bool is_interrupted(const Hooks& hooks) {
  if constexpr (requires { hooks.is_interrupted(); }) {
    return hooks.is_interrupted();
  } else {
    return static_cast<void>(hooks), false;
  }
}

/// Hooks without effect or cost.
struct NoHooks {
  void on_episode(std::uint32_t /*index*/) {}
  template <class Message>
  void on_message(std::uint32_t /*channel*/, Seq /*seq*/, const Message& /*message*/) {}
};

}  // namespace eagerx

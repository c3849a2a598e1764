// Start, reset, safe state and stop of a program's engine, and all counts of a run.
#pragma once

#include <cstdint>
#include <eagerx/channel_counts.hpp>

namespace eagerx {

/// Once, before the first reset: calls engine.start(simulators...) if the engine has it, otherwise
/// every simulator's reset(). An engine that uses a library allocates its memory here.
template <class Engine, class... Simulators>
void start(Engine& engine, Simulators&... simulators) {
  if constexpr (requires { engine.start(simulators...); }) {
    engine.start(simulators...);
  } else {
    (simulators.reset(), ...);
  }
}

/// At every reset, after the engine states: calls engine.reset(states, simulators...) if the engine
/// has it, otherwise engine.reset(states).
template <class Engine, class States, class... Simulators>
void reset_engine(Engine& engine, const States& states, Simulators&... simulators) {
  if constexpr (requires { engine.reset(states, simulators...); }) {
    engine.reset(states, simulators...);
  } else {
    engine.reset(states);
  }
}

/// Whether the engine acts on the real world, so that nothing can be tried or repeated: such an
/// engine has `static constexpr bool kReal = true`.
template <class Engine, class... Simulators>
constexpr bool is_real(const Engine& /*engine*/, const Simulators&... /*simulators*/) {
  if constexpr (requires { Engine::kReal; }) {
    return Engine::kReal;
  } else {
    return false;
  }
}

/// In the middle of a slot, if the rest of the graph does not answer: calls
/// engine.make_safe(simulators...) if the engine has it.
template <class Engine, class... Simulators>
void make_safe(Engine& engine, Simulators&... simulators) {
  if constexpr (requires { engine.make_safe(simulators...); }) engine.make_safe(simulators...);
}

/// At the end of a run: calls engine.stop(simulators...) if the engine has it.
template <class Engine, class... Simulators>
void stop(Engine& engine, Simulators&... simulators) {
  if constexpr (requires { engine.stop(simulators...); }) engine.stop(simulators...);
}

/// Calls f(name, count) for each count of `part`, an engine or a simulator.
template <class F, class Part>
void for_each_count_of(F& f, const Part& part) {
  if constexpr (requires { part.for_each_count(f); }) part.for_each_count(f);
}

/// The same for a node, whose counts are named "name: count". The text is valid during the call.
template <class F, class Node>
void for_each_count_of_node(F& f, const char* name, const Node& node) {
  node.for_each_count(
      [&](const char* what, std::uint64_t count) { tell_count(f, name, what, count); });
}

/// The same for an engine and its simulators.
template <class F, class... Parts>
void for_each_count(F& f, const Parts&... parts) {
  (for_each_count_of(f, parts), ...);
}

}  // namespace eagerx

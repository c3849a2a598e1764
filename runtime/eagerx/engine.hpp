// How a program starts and resets its engine.
#pragma once

namespace eagerx {

/// Once, before the first reset: engine.start(simulators...) where the engine has one, else every
/// simulator's reset(). An engine that is built on a library gets its memory here.
template <class Engine, class... Simulators>
void start(Engine& engine, Simulators&... simulators) {
  if constexpr (requires { engine.start(simulators...); }) {
    engine.start(simulators...);
  } else {
    (simulators.reset(), ...);
  }
}

/// At every reset, after the engine states: engine.reset(states, simulators...) where the engine
/// has one, else engine.reset(states).
template <class Engine, class States, class... Simulators>
void reset_engine(Engine& engine, const States& states, Simulators&... simulators) {
  if constexpr (requires { engine.reset(states, simulators...); }) {
    engine.reset(states, simulators...);
  } else {
    engine.reset(states);
  }
}

}  // namespace eagerx

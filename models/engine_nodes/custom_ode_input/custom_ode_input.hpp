// Sets the input of an object simulated by OdeEngine, with a delay that is a state.
#pragma once

#include <eagerx/rate.hpp>
#include <models/engine_nodes/ode_input/ode_input.hpp>

namespace eagerx::models {

/// OdeInput; at a reset that sets the state `delay` [s], that becomes the delay of `action`.
/// Source: eagerx_dcsc_setups, pendulum/ode/engine_nodes.py.
template <class Io>
class CustomOdeInput : OdeInput<Io> {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& states, const typename Io::Delays& delays,
             Simulator& simulator) {
    if (states.delay) delays.action = static_cast<double>(*states.delay);
    OdeInput<Io>::reset(states, simulator);
  }

  void callback(const Tick& tick, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& simulator) {
    OdeInput<Io>::callback(tick, in, out, simulator);
  }
};

}  // namespace eagerx::models

// The engine of step-by-step environments.
#pragma once

#include <eagerx/rate.hpp>
#include <models/engines/gym_engine/gym_simulator.hpp>

namespace eagerx::models {

/// Makes one step of every object's GymSimulator at each tick, at any rate of the engine.
template <class Io>
class GymEngine {
 public:
  void reset(const typename Io::States& /*states*/) {}

  template <class... Simulators>
  void callback(const Tick& /*tick*/, Simulators&... simulators) {
    (simulators.step(), ...);
  }
};

}  // namespace eagerx::models

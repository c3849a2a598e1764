// MuJoCo as an engine of the tests.
#pragma once

#include <eagerx/rate.hpp>
#include <tests/mujoco/engine/mujoco_simulator.hpp>

namespace eagerx::mujoco {

/// Each object is a world of its own.
template <class Io>
class MujocoEngine {
 public:
  template <class... Simulators>
  void start(Simulators&... simulators) {
    const PlantSettings settings{
        {.step_s = Io::Rate::period_s / Config::substeps, .options = Config::options},
        Config::contact_time};
    (simulators.start(settings), ...);
  }
  template <class... Simulators>
  void reset(const typename Io::States& /*states*/, Simulators&... simulators) {
    (simulators.begin_episode(), ...);
  }
  template <class... Simulators>
  void callback(const Tick& /*tick*/, Simulators&... simulators) {
    (simulators.advance(Config::substeps), ...);
  }

 private:
  using Config = typename Io::Config;
};

}  // namespace eagerx::mujoco

// Io structs of the entities of GymEngine, as the generator emits them.
#pragma once

#include <models/engines/gym_engine/gym_simulator.hpp>
#include <models/objects/gym_pendulum/gym_pendulum.hpp>

#include "tests/unit/models/entity_io.hpp"

namespace eagerx::models::testing {

template <class Real>
using GymPendulumSimulator = GymSimulator<GymPendulum<PendulumModelIo<Real>>>;

template <class Simulator>
struct ObservationSensorIo : NodeIo<Simulator> {
  struct Config {
    static constexpr int size = 3;
  };
  struct Inputs {
    Latest<std::int64_t> tick;
  };
  struct Outputs {
    Array<float, 3>& observation;
  };
};

template <class Simulator>
struct RewardSensorIo : NodeIo<Simulator> {
  struct Inputs {
    Latest<std::int64_t> tick;
  };
  struct Outputs {
    float& reward;
  };
};

/// For both flags.
template <class Simulator>
struct FlagSensorIo : NodeIo<Simulator> {
  struct Inputs {
    Latest<std::int64_t> tick;
  };
  struct Outputs {
    std::int64_t& terminated;
    std::int64_t& truncated;
  };
};

template <class Simulator, template <class> class WindowOf = Latest>
struct ActionActuatorIo : NodeIo<Simulator> {
  struct Config {
    static constexpr std::array<double, 1> zero_action = {0.25};
  };
  struct Inputs {
    Latest<std::int64_t> tick;
    WindowOf<Voltage> action;
  };
  struct Outputs {
    Voltage& action_applied;
  };
};

template <class Simulator>
struct MassIo : StateIo<Simulator, float> {
  struct Config {
    static constexpr const char* attribute = "m";
  };
};
template <class Simulator>
struct MirroredStateIo : StateIo<Simulator, TwoFloats> {
  struct Config {
    static constexpr std::array<double, 2> factors = {-1.0, -1.0};
  };
};

}  // namespace eagerx::models::testing

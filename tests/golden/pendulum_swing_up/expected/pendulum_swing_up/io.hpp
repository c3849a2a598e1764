// The interface of each node of graph `pendulum_swing_up`: rate, parameters, inputs, outputs.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <array>
#include <cstdint>
#include <models/engine_nodes/action_applied/action_applied.hpp>
#include <models/engine_nodes/float_output/float_output.hpp>
#include <models/engine_nodes/ode_input/ode_input.hpp>
#include <models/engine_nodes/ode_output/ode_output.hpp>
#include <models/engine_nodes/pendulum_drawing/pendulum_drawing.hpp>
#include <models/engine_states/dummy_state/dummy_state.hpp>
#include <models/engine_states/ode_engine_state/ode_engine_state.hpp>
#include <models/engines/ode_engine/ode_engine.hpp>
#include <models/engines/ode_engine/ode_simulator.hpp>
#include <models/nodes/butterworth_filter/butterworth_filter.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>
#include <models/processors/decomposed_angle/decomposed_angle.hpp>

#include "pendulum_swing_up/messages.hpp"

namespace graphs::pendulum_swing_up {

/// The number type of engines and nodes.
using Real = float;

/// Numbers of the published messages in the trace.
namespace channel {
inline constexpr std::uint32_t engine_tick = 0;
inline constexpr std::uint32_t environment_voltage = 1;
inline constexpr std::uint32_t pendulum_theta_observation = 2;
inline constexpr std::uint32_t pendulum_theta_dot_observation = 3;
inline constexpr std::uint32_t pendulum_u_action_applied = 4;
inline constexpr std::uint32_t pendulum_u_applied_action_applied = 5;
inline constexpr std::uint32_t pendulum_x_observation = 6;
inline constexpr std::uint32_t smooth_filtered = 7;
}  // namespace channel

// pendulum: Pendulum on OdeEngine
struct PendulumSimulatorIo {
  using Real = graphs::pendulum_swing_up::Real;
  struct Config {};
};
using PendulumSimulator =
    eagerx::models::OdeSimulator<eagerx::models::PendulumOde<PendulumSimulatorIo>>;

// pendulum.states.model_state: OdeEngineState
struct PendulumModelStateIo {
  using Real = graphs::pendulum_swing_up::Real;
  using State = eagerx::Array<float, 2>;
  using Simulator = PendulumSimulator;
  struct Config {};
};
using PendulumModelState = eagerx::models::OdeEngineState<PendulumModelStateIo>;

// pendulum.states.mass: DummyState
struct PendulumMassIo {
  using Real = graphs::pendulum_swing_up::Real;
  using State = float;
  using Simulator = PendulumSimulator;
  struct Config {};
};
using PendulumMass = eagerx::models::DummyState<PendulumMassIo>;

// pendulum.states.length: DummyState
struct PendulumLengthIo {
  using Real = graphs::pendulum_swing_up::Real;
  using State = float;
  using Simulator = PendulumSimulator;
  struct Config {};
};
using PendulumLength = eagerx::models::DummyState<PendulumLengthIo>;

// pendulum.states.max_speed: DummyState
struct PendulumMaxSpeedIo {
  using Real = graphs::pendulum_swing_up::Real;
  using State = float;
  using Simulator = PendulumSimulator;
  struct Config {};
};
using PendulumMaxSpeed = eagerx::models::DummyState<PendulumMaxSpeedIo>;

// observations.angle: DecomposedAngle
struct ObservationAngleProcessorIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Input = float;
  using Output = eagerx::Array<float, 2>;
  struct Config {};
};
using ObservationAngleProcessor = eagerx::models::DecomposedAngle<ObservationAngleProcessorIo>;

// engine: OdeEngine at 30 Hz
struct EngineIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr auto method = eagerx::models::OdeMethod::rk4;
    static constexpr int substeps = 30;
    static constexpr double rtol = 2e-08;
    static constexpr double atol = 2e-08;
    static constexpr double hmax = 0.0;  // s
    static constexpr double hmin = 0.0;  // s
    static constexpr int mxstep = 0;
  };
  struct States {};
};

// smooth: ButterworthFilter at 30 Hz
struct SmoothIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr int order = 2;
    static constexpr auto type = eagerx::models::FilterType::lowpass;
    static constexpr std::array<double, 1> cutoff_hz = {12.0};  // Hz
    static constexpr auto initial = eagerx::models::FilterInitial::zero;
  };
  struct Inputs {
    eagerx::Window<eagerx::Array<float, 1>, eagerx::Rate<30>, 1, 1, true> signal;  // float32 [1]

    template <class F>
    void for_each(F&& f) const {
      f("signal", this->signal);
    }
  };
  struct Outputs {
    eagerx::Array<float, 1>& filtered;
  };
  struct States {};
};

// pendulum/x: OdeOutput at 30 Hz
struct PendulumXIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr int size = 2;
  };
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<30>, 1, 1, true> tick;  // int64 []

    template <class F>
    void for_each(F&& f) const {
      f("tick", this->tick);
    }
  };
  struct Outputs {
    eagerx::Array<float, 2>& observation;
  };
  struct States {};
  using Simulator = PendulumSimulator;
};

// pendulum/theta: FloatOutput at 30 Hz
struct PendulumThetaIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr int idx = 0;
  };
  struct Inputs {
    // float32 [2]
    eagerx::Window<eagerx::Array<float, 2>, eagerx::Rate<30>, 1, 1, true> observation_array;

    template <class F>
    void for_each(F&& f) const {
      f("observation_array", this->observation_array);
    }
  };
  struct Outputs {
    float& observation;
  };
  struct States {};
  using Simulator = PendulumSimulator;
};

// pendulum/theta_dot: FloatOutput at 30 Hz
struct PendulumThetaDotIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr int idx = 1;
  };
  struct Inputs {
    // float32 [2]
    eagerx::Window<eagerx::Array<float, 2>, eagerx::Rate<30>, 1, 1, true> observation_array;

    template <class F>
    void for_each(F&& f) const {
      f("observation_array", this->observation_array);
    }
  };
  struct Outputs {
    float& observation;
  };
  struct States {};
  using Simulator = PendulumSimulator;
};

// pendulum/u: OdeInput at 30 Hz
struct PendulumUIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr std::array<double, 1> default_action = {0.0};
  };
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<30>, 1, 1, true> tick;               // int64 []
    eagerx::Window<eagerx::Array<float, 1>, eagerx::Rate<30>, 1, 1, true> action;  // float32 [1]

    template <class F>
    void for_each(F&& f) const {
      f("tick", this->tick);
      f("action", this->action);
    }
  };
  struct Outputs {
    eagerx::Array<float, 1>& action_applied;
  };
  struct States {};
  using Simulator = PendulumSimulator;
};

// pendulum/u_applied: ActionApplied at 30 Hz
struct PendulumUAppliedIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {};
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<30>, 1, 1, true> tick;  // int64 []
    // float32 [1]
    eagerx::Window<eagerx::Array<float, 1>, eagerx::Rate<30>, 1, 1, false> action_applied;

    template <class F>
    void for_each(F&& f) const {
      f("tick", this->tick);
      f("action_applied", this->action_applied);
    }
  };
  struct Outputs {
    eagerx::Array<float, 1>& action_applied;
  };
  struct States {};
  using Simulator = PendulumSimulator;
};

// pendulum/scene: PendulumDrawing at 30 Hz
struct PendulumSceneIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr double length = 0.042;  // m
    static constexpr bool weight = true;
    static constexpr bool clockwise = true;
  };
  struct Inputs {
    eagerx::Window<float, eagerx::Rate<30>, 1, 1, true> angle;  // float32 []

    template <class F>
    void for_each(F&& f) const {
      f("angle", this->angle);
    }
  };
  struct Outputs {
    eagerx::Array<float, 24, 16>& scene;
  };
  struct States {};
  using Simulator = PendulumSimulator;
};

// render: Render at 30 Hz
struct RenderIo {
  using Real = graphs::pendulum_swing_up::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {};
  struct Inputs {
    // float32 [24, 16]
    eagerx::Window<eagerx::Array<float, 24, 16>, eagerx::Rate<30>, 1, 1, true> source;

    template <class F>
    void for_each(F&& f) const {
      f("source", this->source);
    }
  };
  struct Outputs {};
  struct States {};
};

}  // namespace graphs::pendulum_swing_up

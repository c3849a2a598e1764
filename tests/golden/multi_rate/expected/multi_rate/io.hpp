// The interface of each node of graph `multi_rate`: rate, parameters, inputs, outputs.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <array>
#include <cstdint>
#include <models/engine_nodes/action_applied/action_applied.hpp>
#include <models/engine_nodes/float_output/float_output.hpp>
#include <models/engine_nodes/ode_input/ode_input.hpp>
#include <models/engine_nodes/ode_output/ode_output.hpp>
#include <models/engine_states/dummy_state/dummy_state.hpp>
#include <models/engine_states/ode_engine_state/ode_engine_state.hpp>
#include <models/engines/ode_engine/ode_engine.hpp>
#include <models/engines/ode_engine/ode_simulator.hpp>
#include <models/nodes/butterworth_filter/butterworth_filter.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>
#include <models/processors/decomposed_angle/decomposed_angle.hpp>
#include <models/processors/identity/identity.hpp>
#include <models/processors/negate/negate.hpp>

#include "multi_rate/messages.hpp"

namespace graphs::multi_rate {

/// The number type of engines and nodes.
using Real = double;

/// Numbers of the published messages in the trace.
namespace channel {
inline constexpr std::uint32_t engine_tick = 0;
inline constexpr std::uint32_t environment_push = 1;
inline constexpr std::uint32_t environment_voltage = 2;
inline constexpr std::uint32_t fast_filtered = 3;
inline constexpr std::uint32_t left_theta_observation = 4;
inline constexpr std::uint32_t left_theta_dot_observation = 5;
inline constexpr std::uint32_t left_u_action_applied = 6;
inline constexpr std::uint32_t left_u_applied_action_applied = 7;
inline constexpr std::uint32_t left_x_observation = 8;
inline constexpr std::uint32_t right_theta_observation = 9;
inline constexpr std::uint32_t right_u_action_applied = 10;
inline constexpr std::uint32_t right_u_applied_action_applied = 11;
inline constexpr std::uint32_t right_x_observation = 12;
inline constexpr std::uint32_t slow_filtered = 13;
}  // namespace channel

// left: Pendulum on OdeEngine
struct LeftSimulatorIo {
  using Real = graphs::multi_rate::Real;
  struct Config {};
};
using LeftSimulator = eagerx::models::OdeSimulator<eagerx::models::PendulumOde<LeftSimulatorIo>>;

// right: Pendulum on OdeEngine
struct RightSimulatorIo {
  using Real = graphs::multi_rate::Real;
  struct Config {};
};
using RightSimulator = eagerx::models::OdeSimulator<eagerx::models::PendulumOde<RightSimulatorIo>>;

// left.states.model_state: OdeEngineState
struct LeftModelStateIo {
  using Real = graphs::multi_rate::Real;
  using State = eagerx::Array<float, 2>;
  using Simulator = LeftSimulator;
  struct Config {};
};
using LeftModelState = eagerx::models::OdeEngineState<LeftModelStateIo>;

// left.states.mass: DummyState
struct LeftMassIo {
  using Real = graphs::multi_rate::Real;
  using State = float;
  using Simulator = LeftSimulator;
  struct Config {};
};
using LeftMass = eagerx::models::DummyState<LeftMassIo>;

// left.states.length: DummyState
struct LeftLengthIo {
  using Real = graphs::multi_rate::Real;
  using State = float;
  using Simulator = LeftSimulator;
  struct Config {};
};
using LeftLength = eagerx::models::DummyState<LeftLengthIo>;

// right.states.model_state: OdeEngineState
struct RightModelStateIo {
  using Real = graphs::multi_rate::Real;
  using State = eagerx::Array<float, 2>;
  using Simulator = RightSimulator;
  struct Config {};
};
using RightModelState = eagerx::models::OdeEngineState<RightModelStateIo>;

// right.states.max_speed: DummyState
struct RightMaxSpeedIo {
  using Real = graphs::multi_rate::Real;
  using State = float;
  using Simulator = RightSimulator;
  struct Config {};
};
using RightMaxSpeed = eagerx::models::DummyState<RightMaxSpeedIo>;

// right.states.length: DummyState
struct RightLengthIo {
  using Real = graphs::multi_rate::Real;
  using State = float;
  using Simulator = RightSimulator;
  struct Config {};
};
using RightLength = eagerx::models::DummyState<RightLengthIo>;

// observations.angle: DecomposedAngle
struct ObservationAngleProcessorIo {
  using Real = graphs::multi_rate::Real;
  using Input = float;
  using Output = eagerx::Array<float, 2>;
  struct Config {};
};
using ObservationAngleProcessor = eagerx::models::DecomposedAngle<ObservationAngleProcessorIo>;

// fast.filtered: Negate
struct FastFilteredProcessorIo {
  using Real = graphs::multi_rate::Real;
  using Input = eagerx::Array<float, 1>;
  using Output = eagerx::Array<float, 1>;
  struct Config {};
};
using FastFilteredProcessor = eagerx::models::Negate<FastFilteredProcessorIo>;

// left/theta_dot.observation: Negate
struct LeftThetaDotObservationProcessorIo {
  using Real = graphs::multi_rate::Real;
  using Input = float;
  using Output = float;
  struct Config {};
};
using LeftThetaDotObservationProcessor = eagerx::models::Negate<LeftThetaDotObservationProcessorIo>;

// right/u.action: Identity
struct RightUActionProcessorIo {
  using Real = graphs::multi_rate::Real;
  using Input = eagerx::Array<float, 1>;
  using Output = eagerx::Array<float, 1>;
  struct Config {};
};
using RightUActionProcessor = eagerx::models::Identity<RightUActionProcessorIo>;

// engine: OdeEngine at 60 Hz
struct EngineIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<60>;
  struct Config {
    static constexpr auto method = eagerx::models::OdeMethod::rk4;
    static constexpr int substeps = 4;
    static constexpr double rtol = 2e-08;
    static constexpr double atol = 2e-08;
    static constexpr double hmax = 0.0;  // s
    static constexpr double hmin = 0.0;  // s
    static constexpr int mxstep = 0;
  };
  struct States {};
};

// slow: ButterworthFilter at 20 Hz
struct SlowIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<20>;
  struct Config {
    static constexpr int order = 1;
    static constexpr auto type = eagerx::models::FilterType::lowpass;
    static constexpr std::array<double, 1> cutoff_hz = {4.0};  // Hz
    static constexpr auto initial = eagerx::models::FilterInitial::zero;
  };
  struct Inputs {
    eagerx::Window<eagerx::Array<float, 1>, eagerx::Rate<10>, 4, 1, true> signal;  // float32 [1]

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

// fast: ButterworthFilter at 30 Hz
struct FastIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr int order = 3;
    static constexpr auto type = eagerx::models::FilterType::bandpass;
    static constexpr std::array<double, 2> cutoff_hz = {2.0, 9.0};  // Hz
    static constexpr auto initial = eagerx::models::FilterInitial::zero;
  };
  struct Inputs {
    eagerx::Window<eagerx::Array<float, 1>, eagerx::Rate<10>, 4, 3, false> signal;  // float32 [1]

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

// left/x: OdeOutput at 20 Hz
struct LeftXIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<20>;
  struct Config {
    static constexpr int size = 2;
  };
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<60>, 1, 1, true> tick;  // int64 []

    template <class F>
    void for_each(F&& f) const {
      f("tick", this->tick);
    }
  };
  struct Outputs {
    eagerx::Array<float, 2>& observation;
  };
  struct States {};
  using Simulator = LeftSimulator;
};

// left/theta: FloatOutput at 20 Hz
struct LeftThetaIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<20>;
  struct Config {
    static constexpr int idx = 0;
  };
  struct Inputs {
    // float32 [2]
    eagerx::Window<eagerx::Array<float, 2>, eagerx::Rate<20>, 1, 1, true> observation_array;

    template <class F>
    void for_each(F&& f) const {
      f("observation_array", this->observation_array);
    }
  };
  struct Outputs {
    float& observation;
  };
  struct States {};
  using Simulator = LeftSimulator;
};

// left/theta_dot: FloatOutput at 30 Hz
struct LeftThetaDotIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr int idx = 1;
  };
  struct Inputs {
    // float32 [2]
    eagerx::Window<eagerx::Array<float, 2>, eagerx::Rate<20>, 1, 1, true> observation_array;

    template <class F>
    void for_each(F&& f) const {
      f("observation_array", this->observation_array);
    }
  };
  struct Outputs {
    float& observation;
  };
  struct States {};
  using Simulator = LeftSimulator;
};

// left/u: OdeInput at 30 Hz
struct LeftUIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {
    static constexpr std::array<double, 1> default_action = {0.0};
  };
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<60>, 1, 1, true> tick;                // int64 []
    eagerx::Window<eagerx::Array<float, 1>, eagerx::Rate<20>, 2, 2, false> action;  // float32 [1]

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
  using Simulator = LeftSimulator;
};

// left/u_applied: ActionApplied at 10 Hz
struct LeftUAppliedIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<10>;
  struct Config {};
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<60>, 1, 1, true> tick;  // int64 []
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
  using Simulator = LeftSimulator;
};

// right/x: OdeOutput at 15 Hz
struct RightXIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<15>;
  struct Config {
    static constexpr int size = 2;
  };
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<60>, 1, 1, true> tick;  // int64 []

    template <class F>
    void for_each(F&& f) const {
      f("tick", this->tick);
    }
  };
  struct Outputs {
    eagerx::Array<float, 2>& observation;
  };
  struct States {};
  using Simulator = RightSimulator;
};

// right/theta: FloatOutput at 15 Hz
struct RightThetaIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<15>;
  struct Config {
    static constexpr int idx = 0;
  };
  struct Inputs {
    // float32 [2]
    eagerx::Window<eagerx::Array<float, 2>, eagerx::Rate<15>, 1, 1, true> observation_array;

    template <class F>
    void for_each(F&& f) const {
      f("observation_array", this->observation_array);
    }
  };
  struct Outputs {
    float& observation;
  };
  struct States {};
  using Simulator = RightSimulator;
};

// right/u: OdeInput at 20 Hz
struct RightUIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<20>;
  struct Config {
    static constexpr std::array<double, 1> default_action = {0.0};
  };
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<60>, 1, 1, true> tick;               // int64 []
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
  using Simulator = RightSimulator;
};

// right/u_applied: ActionApplied at 30 Hz
struct RightUAppliedIo {
  using Real = graphs::multi_rate::Real;
  using Rate = eagerx::Rate<30>;
  struct Config {};
  struct Inputs {
    eagerx::Window<std::int64_t, eagerx::Rate<60>, 1, 1, true> tick;  // int64 []
    // float32 [1]
    eagerx::Window<eagerx::Array<float, 1>, eagerx::Rate<20>, 1, 1, false> action_applied;

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
  using Simulator = RightSimulator;
};

}  // namespace graphs::multi_rate

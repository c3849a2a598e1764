// Io structs of the entities other than the engine, as the generator emits them.
#pragma once

#include <models/nodes/butterworth_filter/butterworth_design.hpp>
#include <optional>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {

using Voltage = Array<float, 1>;
using TwoFloats = Array<float, 2>;

template <class SimulatorType>
struct NodeIo {
  using Real = typename SimulatorType::Real;
  using Rate = eagerx::Rate<30>;
  using Config = NoConfig;
  using States = NoStates;
  using Simulator = SimulatorType;
};

template <class Simulator, template <class> class WindowOf>
struct OdeInputIo : NodeIo<Simulator> {
  struct Config {
    static constexpr std::array<double, 1> default_action = {0.25};
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
struct OdeOutputIo : NodeIo<Simulator> {
  struct Config {
    static constexpr int size = 2;
  };
  struct Inputs {
    Latest<std::int64_t> tick;
  };
  struct Outputs {
    TwoFloats& observation;
  };
};

template <class Simulator, template <class> class WindowOf>
struct FloatOutputIo : NodeIo<Simulator> {
  struct Config {
    static constexpr int idx = 1;
  };
  struct Inputs {
    WindowOf<TwoFloats> observation_array;
  };
  struct Outputs {
    float& observation;
  };
};

template <class Simulator>
struct ActionAppliedIo : NodeIo<Simulator> {
  struct Inputs {
    Latest<std::int64_t> tick;
    Skipped<Voltage> action_applied;
  };
  struct Outputs {
    Voltage& action_applied;
  };
};

template <class SimulatorType, class StateType>
struct StateIo {
  using Real = typename SimulatorType::Real;
  using Simulator = SimulatorType;
  using State = StateType;
  struct Config {};
};

template <class Simulator>
struct TwoParametersIo : StateIo<Simulator, TwoFloats> {
  struct Config {
    static constexpr std::array<int, 2> indices = {6, 1};
  };
};
template <class Simulator>
struct AllParametersIo : StateIo<Simulator, Array<float, 8>> {
  struct Config {
    static constexpr std::array<int, 2> indices = {6, 1};
  };
};
template <class Simulator>
struct CustomOdeInputIo : OdeInputIo<Simulator, Latest> {
  struct States {
    std::optional<float> delay{};
  };
  struct Delays {
    double& action;
  };
};
template <class Simulator>
struct OneParameterIo : StateIo<Simulator, float> {
  struct Config {
    static constexpr std::array<int, 1> indices = {2};
  };
};

template <class Simulator>
struct OdeFloatOutputIo : NodeIo<Simulator> {
  struct Config {
    static constexpr int idx = 1;
  };
  struct Inputs {
    Latest<std::int64_t> tick;
  };
  struct Outputs {
    float& observation;
  };
};

struct Low2 {
  static constexpr auto initial = FilterInitial::zero;
  static constexpr int order = 2;
  static constexpr auto type = FilterType::lowpass;
  static constexpr std::array<double, 1> cutoff_hz = {10.0};
};
struct High3 {
  static constexpr auto initial = FilterInitial::zero;
  static constexpr int order = 3;
  static constexpr auto type = FilterType::highpass;
  static constexpr std::array<double, 1> cutoff_hz = {2.0};
};
struct Band4 {
  static constexpr auto initial = FilterInitial::zero;
  static constexpr int order = 4;
  static constexpr auto type = FilterType::bandpass;
  static constexpr std::array<double, 2> cutoff_hz = {3.0, 8.0};
};
struct Stop8 {
  static constexpr auto initial = FilterInitial::zero;
  static constexpr int order = 8;
  static constexpr auto type = FilterType::bandstop;
  static constexpr std::array<double, 2> cutoff_hz = {5.0, 12.0};
};

template <class RealType, class ConfigType, class RateType, class Message,
          template <class> class WindowOf = Latest>
struct FilterIo {
  using Real = RealType;
  using Config = ConfigType;
  using Rate = RateType;
  using States = NoStates;
  struct Inputs {
    WindowOf<Message> signal;
  };
  struct Outputs {
    Message& filtered;
  };
};

template <class RealType, class InputType, class OutputType>
struct ProcessorIo {
  using Real = RealType;
  using Input = InputType;
  using Output = OutputType;
  struct Config {
    static constexpr int index = 2;
    static constexpr int size = 4;
    static constexpr double K = 0.5;
    static constexpr double R = 8.0;
  };
};

template <class InputType, int... Indices>
struct IndexIo {
  using Real = float;
  using Input = InputType;
  using Output = Array<float, sizeof...(Indices)>;
  struct Config {
    static constexpr std::array<int, sizeof...(Indices)> index = {Indices...};
  };
};

template <class RealType, class Message, class Result, template <class> class WindowOf = Latest>
struct MeanIo {
  using Real = RealType;
  using Rate = eagerx::Rate<30>;
  using States = NoStates;
  struct Config {
    static constexpr int n = 4;
    static constexpr auto initial = FilterInitial::zero;
  };
  struct Inputs {
    WindowOf<Message> signal;
  };
  struct Outputs {
    Result& filtered;
  };
};

/// Of EAGERx's tests: `FilterConfig` is one of the above, whose order is also the window.
template <class RealType, class FilterConfig, class RateType, std::uint32_t Size, bool AlwaysFull>
struct WindowedIo {
  using Real = RealType;
  using Rate = RateType;
  using States = NoStates;
  struct Config {
    static constexpr int index = 1;
    static constexpr int N = FilterConfig::order;
    static constexpr auto Wn = FilterConfig::cutoff_hz;
    static constexpr auto btype = FilterConfig::type;
  };
  struct Inputs {
    Window<TwoFloats, RateType, 16, Size, AlwaysFull> signal;
  };
  struct Outputs {
    Array<float, 1>& filtered;
  };
};

/// Of both reset nodes; gains and limits as in EAGERx's tutorials.
template <class RealType>
struct ResetAngleIo {
  using Real = RealType;
  using Rate = eagerx::Rate<30>;
  using States = NoStates;
  struct Config {
    static constexpr double threshold = 0.1;
    static constexpr double timeout = 5.0;
    static constexpr std::array<double, 3> gains = {1.0, 0.5, 0.25};
    static constexpr std::array<double, 2> u_range = {-2.0, 2.0};
  };
  struct Inputs {
    Latest<float> theta;
    Latest<float> theta_dot;
  };
  struct Outputs {
    Voltage& u;
  };
  struct Targets {
    std::optional<TwoFloats> goal{};
  };
  struct Done {
    bool goal = false;
  };
};
template <class Real>
struct ResetDecomposedAngleIo : ResetAngleIo<Real> {
  struct Inputs {
    Latest<Array<float, 3>> x;
  };
};

}  // namespace eagerx::models::testing

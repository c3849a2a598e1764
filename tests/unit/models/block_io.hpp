// Io structs of blocks, as the generator emits them.
#pragma once

#include <limits>
#include <models/nodes/integrator/integrator.hpp>
#include <models/nodes/lookup_table/lookup_table.hpp>
#include <models/nodes/reference/reference.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>
#include <optional>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing::blocks {

constexpr double kInf = std::numeric_limits<double>::infinity();

template <class Real, std::size_t N = 1>
using V = Array<Real, N>;
template <class RealType, class ConfigType, std::uint64_t Hz = 100>
struct BlockIo {
  using Real = RealType;
  using Rate = eagerx::Rate<Hz>;
  using Config = ConfigType;
  using States = NoStates;
};

/// One input, one output of the same shape.
template <class Real, class Config, std::size_t N = 1, std::size_t M = N, std::uint64_t Hz = 100>
struct SignalIo : BlockIo<Real, Config, Hz> {
  struct Inputs {
    Skipped<V<Real, N>> signal;
  };
  struct Outputs {
    V<Real, M>& y;
  };
};
/// Inputs a and b.
template <class Real, class Config, std::size_t N = 1>
struct PairIo : BlockIo<Real, Config> {
  struct Inputs {
    Skipped<V<Real, N>> a;
    Skipped<V<Real, N>> b;
  };
  struct Outputs {
    V<Real, N>& y;
  };
};
template <class Real, class Config>
struct SourceIo : BlockIo<Real, Config> {
  struct Inputs {};
  struct Outputs {
    V<Real>& y;
  };
};

// Of blocks without memory, and sources.
struct SumConfig {
  static constexpr std::array<double, 3> gains = {1.0, -2.0, 0.5};
};
template <class Real>
struct SumIo : BlockIo<Real, SumConfig> {
  struct Inputs {
    Skipped<V<Real, 2>> a;
    Skipped<V<Real, 2>> b;
    Skipped<V<Real, 2>> c;
  };
  struct Outputs {
    V<Real, 2>& y;
  };
};
struct DifferenceConfig {
  static constexpr double turn = 0.0;
};
struct AngleConfig {
  static constexpr double turn = 2.0;
};
template <class Real, class Config>
struct DifferenceIoOf : BlockIo<Real, Config> {
  struct Inputs {
    Skipped<V<Real>> plus;
    Skipped<Real> minus;
  };
  struct Outputs {
    V<Real>& y;
  };
};
template <class Real>
struct AngleIo : DifferenceIoOf<Real, AngleConfig> {
  struct Inputs {
    Skipped<V<Real>> plus;
    Skipped<V<Real>> minus;
  };
};
struct GainConfig {
  static constexpr std::array<double, 2> gain = {3.0, -0.5};
};
template <class Real>
using GainIo = SignalIo<Real, GainConfig, 2>;
template <class Real>
struct TunedGainIo : GainIo<Real> {
  struct States {
    std::optional<V<float, 2>> gain{};
  };
};
struct MatrixConfig {
  static constexpr std::array<double, 6> gain = {1.0, 2.0, 3.0, 4.0, -5.0, 0.1};
};
template <class Real>
using MatrixIo = SignalIo<Real, MatrixConfig, 2, 3>;
struct ConstantConfig {
  static constexpr std::array<double, 1> value = {2.5};
};
template <class Real>
struct SampledConstantIo : SourceIo<Real, ConstantConfig> {
  struct States {
    std::optional<V<float>> value{};
  };
};
template <ReferenceShape Shape>
struct ReferenceConfig {
  static constexpr auto shape = Shape;
  static constexpr double amplitude = 2.0;
  static constexpr double offset = 0.5;
  static constexpr double start = 0.1;
  static constexpr double duration = 2.0;
  static constexpr double frequency = 1.5;
  static constexpr double end_frequency = 4.0;
  static constexpr double phase = 0.0;
  static constexpr std::array<double, 4> times = {0.255, 0.505, 1.005, 2.495};  // table
  static constexpr std::array<double, 4> values = {1.0, -3.0, 0.25, 7.0};
  static constexpr auto interpolation = Interpolation::linear;
};
struct StepsOfTableConfig : ReferenceConfig<ReferenceShape::table> {
  static constexpr auto interpolation = Interpolation::previous;
};
struct LimitsConfig {
  static constexpr std::array<double, 1> low = {-1.0};
  static constexpr std::array<double, 2> high = {2.0, 0.5};
};
template <class Real>
using LimitsIo = SignalIo<Real, LimitsConfig, 2>;
template <class Real>
struct SampledLimitsIo : LimitsIo<Real> {
  struct States {
    std::optional<V<float, 1>> low{};
    std::optional<V<float, 2>> high{};
  };
};
struct StepConfig {
  static constexpr std::array<double, 1> step = {0.25};
};
template <class Real>
using QuantizerIo = SignalIo<Real, StepConfig>;
template <class Real>
using ProductIo = PairIo<Real, NoConfig, 2>;
struct SwitchConfig {
  static constexpr double threshold = 0.5;
};
template <class Real>
struct SwitchIo : BlockIo<Real, SwitchConfig> {
  struct Inputs {
    Skipped<V<Real>> control;
    Skipped<V<Real, 2>> a;
    Skipped<V<Real, 2>> b;
  };
  struct Outputs {
    V<Real, 2>& y;
  };
};
struct MuxConfig {};
template <class Real>
struct MuxIo : BlockIo<Real, MuxConfig> {
  struct Inputs {
    Skipped<V<Real>> a;
    Skipped<V<Real, 3>> b;
  };
  struct Outputs {
    V<Real, 4>& y;
  };
};
struct DemuxConfig {
  static constexpr std::array<int, 3> sizes = {1, 2, 1};
};
template <class Real>
struct DemuxIo : BlockIo<Real, DemuxConfig> {
  struct Inputs {
    Skipped<V<Real, 4>> signal;
  };
  struct Outputs {
    V<Real, 2>& b;
    V<Real, 1>& c;
  };
};
template <Interpolation How, Outside Where>
struct TableConfig {
  static constexpr std::array<double, 4> x = {-1.0, 0.0, 0.5, 3.0};
  static constexpr std::array<double, 4> y = {2.0, 0.1, 1.0, -7.0};
  static constexpr auto interpolation = How;
  static constexpr auto outside = Where;
};
template <class Real>
using TableIo = SignalIo<Real, TableConfig<Interpolation::linear, Outside::hold>>;
template <class Real>
using StepsIo = SignalIo<Real, TableConfig<Interpolation::previous, Outside::hold>>;
struct GridConfig {
  static constexpr std::array<double, 3> a = {0.0, 1.0, 2.5};
  static constexpr std::array<double, 2> b = {-1.0, 1.0};
  static constexpr std::array<double, 6> table = {1.0, 2.0, -3.0, 4.0, 0.5, 6.0};
};
template <class Real>
using GridIo = PairIo<Real, GridConfig>;

// Of blocks with memory.
template <IntegrationMethod Method>
struct IntegratorConfig {
  static constexpr auto method = Method;
  static constexpr std::array<double, 1> initial = {0.0};
  static constexpr std::array<double, 1> low = {-kInf};
  static constexpr std::array<double, 1> high = {kInf};
};
template <class Real>
using BackwardIo = SignalIo<Real, IntegratorConfig<IntegrationMethod::backward>>;
template <class Real>
using ForwardIo = SignalIo<Real, IntegratorConfig<IntegrationMethod::forward>>;
template <class Real>
using TrapezoidalIo = SignalIo<Real, IntegratorConfig<IntegrationMethod::trapezoidal>>;
struct LimitedConfig {
  static constexpr auto method = IntegrationMethod::backward;
  static constexpr std::array<double, 2> initial = {0.25, 9.0};
  static constexpr std::array<double, 1> low = {-1.0};
  static constexpr std::array<double, 1> high = {0.5};
};
struct BeginningIo : SignalIo<double, LimitedConfig, 2> {
  struct States {
    std::optional<V<float, 2>> value{};
  };
};
struct LagConfig {
  static constexpr double time_constant = 0.05;
  static constexpr double turn = 0.0;
};
struct NoFilterConfig {
  static constexpr double time_constant = 0.0;
  static constexpr double turn = 0.0;
};
template <class Real>
using DerivativeIo = SignalIo<Real, LagConfig>;
struct TransferConfig {
  static constexpr std::array<double, 4> b = {0.2, -0.5, 0.3, 0.1};
  static constexpr std::array<double, 3> a = {2.0, -1.2, 0.7};
};
template <class Real>
using TransferIo = SignalIo<Real, TransferConfig>;
struct SpaceConfig {
  static constexpr int order = 3;
  static constexpr std::array<double, 9> a = {0.9, 0.2, 0.0, -0.1, 0.8, 0.05, 0.3, 0.0, 0.7};
  static constexpr std::array<double, 6> b = {0.1, 0.0, 0.0, -0.2, 0.05, 0.3};
  static constexpr std::array<double, 6> c = {1.0, 0.0, 0.5, 0.0, 2.0, -1.0};
  static constexpr std::array<double, 4> d = {0.0, 0.1, -0.3, 0.0};
  static constexpr std::array<double, 3> initial = {0.5, -1.0, 0.25};
};
template <class Real>
using SpaceIo = SignalIo<Real, SpaceConfig, 2>;
struct LagsConfig {
  static constexpr std::array<double, 1> time_constant = {0.05};
  static constexpr std::array<double, 1> initial = {0.0};
};
template <class Real>
using LagIo = SignalIo<Real, LagsConfig>;
struct SampledLagIo : LagIo<double> {
  struct States {
    std::optional<V<float>> time_constant{};
  };
};
struct PlayConfig {
  static constexpr std::array<double, 1> width = {0.5};
  static constexpr std::array<double, 1> initial = {0.0};
};
template <class Real>
using PlayIo = SignalIo<Real, PlayConfig>;
struct SampledPlayIo : PlayIo<double> {
  struct States {
    std::optional<V<float>> width{};
  };
};
struct DelayConfig {
  static constexpr double delay = 0.0325;
  static constexpr double max_delay = 0.05;
  static constexpr std::array<double, 1> initial = {0.5};
};
template <class Real>
using DelayIo = SignalIo<Real, DelayConfig>;
struct SampledDelayIo : DelayIo<double> {
  struct States {
    std::optional<float> delay{};
  };
};
struct UnitConfig {
  static constexpr std::array<double, 1> initial = {0.5};
};
template <class Real>
using UnitIo = SignalIo<Real, UnitConfig>;
struct MedianConfig {
  static constexpr int n = 5;
};
template <class Real>
using MedianIo = SignalIo<Real, MedianConfig>;
struct CounterConfig {
  static constexpr double threshold = 0.5;
  static constexpr int modulo = 3;
};
template <class Real>
using CounterIo = SignalIo<Real, CounterConfig>;
struct ComplementaryConfig {
  static constexpr double time_constant = 0.05;
  static constexpr double turn = 0.0;
};
struct TurningConfig {
  static constexpr double time_constant = 0.03;
  static constexpr double turn = 2.0;
};
template <class Real, class Config>
struct ComplementaryIoOf : BlockIo<Real, Config> {
  struct Inputs {
    Skipped<V<Real>> measured;
    Skipped<V<Real>> derivative;
  };
  struct Outputs {
    V<Real>& y;
  };
};
template <class Real>
using TurningIo = ComplementaryIoOf<Real, TurningConfig>;
struct SetpointPidConfig {
  static constexpr double kp = 2.0;
  static constexpr double ki = 4.0;
  static constexpr double kd = 0.05;
  static constexpr double setpoint = 0.25;
  static constexpr double turn = 0.0;
  static constexpr double low = -100.0;
  static constexpr double high = 100.0;
};
template <class Real>
struct SetpointPidIo : BlockIo<Real, SetpointPidConfig> {
  struct Inputs {
    Skipped<V<Real>> measured;
    Skipped<V<Real>> setpoint;
    Skipped<V<Real>> feed_forward;
  };
  struct Outputs {
    V<Real>& u;
  };
};
template <class Real>
struct TightPidIo : SetpointPidIo<Real> {
  struct Config : SetpointPidConfig {
    static constexpr double turn = 2.5;
    static constexpr double low = -3.0;
    static constexpr double high = 2.0;
  };
};

// Of StateFeedback, Observer, KalmanFilter and SensorModel.
struct FeedbackConfig {
  static constexpr std::array<double, 4> gain = {2.0, -1.0, 0.5, 4.0};
  static constexpr std::array<double, 2> reference_gain = {3.0, -2.0};
  static constexpr std::array<double, 1> low = {-5.0};
  static constexpr std::array<double, 2> high = {5.0, 1.0};
};
template <class Real>
struct FeedbackIo : BlockIo<Real, FeedbackConfig> {
  struct Inputs {
    Skipped<V<Real, 2>> x;
    Skipped<V<Real>> reference;
  };
  struct Outputs {
    V<Real, 2>& u;
  };
};
/// The system of make_blocks.py.
struct SystemConfig {
  static constexpr int order = 3;
  static constexpr std::array<double, 9> a = {0.9, 0.2, 0.0, -0.1, 0.8, 0.05, 0.3, 0.0, 0.7};
  static constexpr std::array<double, 6> b = {0.1, 0.0, 0.0, -0.2, 0.05, 0.3};
  static constexpr std::array<double, 6> c = {1.0, 0.0, 0.5, 0.0, 2.0, -1.0};
  static constexpr std::array<double, 3> initial = {0.5, -1.0, 0.25};
  static constexpr std::array<double, 6> gain = {0.3, 0.1, 0.0, 0.2, 0.1, -0.1};  // Observer
  static constexpr std::array<double, 3> q = {0.01, 0.02, 0.03};                  // KalmanFilter
  static constexpr std::array<double, 2> r = {0.1, 0.4};
  static constexpr std::array<double, 3> p = {1.0, 2.0, 0.5};
};
template <class Real>
struct SystemIo : BlockIo<Real, SystemConfig> {
  struct Inputs {
    Skipped<V<Real, 2>> measured;
    Skipped<V<Real, 2>> u;
  };
  struct Outputs {
    V<Real, 3>& x;
  };
  struct States {
    std::optional<V<Real, 3>> x{};
  };
};
struct WholeMatricesConfig : SystemConfig {
  static constexpr std::array<double, 9> q = {0.01, 0, 0, 0, 0.02, 0, 0, 0, 0.03};
  static constexpr std::array<double, 9> p = {1.0, 0, 0, 0, 2.0, 0, 0, 0, 0.5};
};
struct WholeMatricesIo : SystemIo<double> {
  using Config = WholeMatricesConfig;
};
/// Pendulum with the measurements of make_blocks.py.
template <class RealType>
struct PendulumModelIo {
  using Real = RealType;
  struct Config {};
  using Model = PendulumOde<PendulumModelIo>;
};
template <class ModelIo>
struct ExtendedConfig {
  using model = ModelIo;
  static constexpr int order = 2;
  static constexpr std::array<double, 0> parameters = {};
  static constexpr std::array<double, 4> c = {1.0, 0.0, 0.5, 1.0};
  static constexpr std::array<double, 1> turn = {0.0};
  static constexpr std::array<double, 2> q = {1e-4, 0.5};
  static constexpr std::array<double, 2> r = {0.01, 0.4};
  static constexpr std::array<double, 2> p = {1.0, 2.0};
  static constexpr std::array<double, 2> initial = {0.5, -1.0};
  static constexpr int substeps = 4;
};
template <class Real, class ConfigType = ExtendedConfig<PendulumModelIo<Real>>>
struct ExtendedIo : BlockIo<Real, ConfigType> {
  struct Inputs {
    Skipped<V<Real, 2>> measured;
    Skipped<V<Real>> u;
  };
  struct Outputs {
    V<Real, 2>& x;
  };
  struct States {
    std::optional<V<Real, 2>> x{};
  };
};
struct IdealConfig {
  static constexpr std::array<double, 1> scale = {1.0};
  static constexpr std::array<double, 1> bias = {0.0};
  static constexpr std::array<double, 1> drift = {0.0};
  static constexpr std::array<double, 1> noise = {0.0};
  static constexpr std::array<double, 1> spread = {0.0};
  static constexpr double drop_out = 0.0;
  static constexpr double resolution = 0.0;
  static constexpr double low = -kInf;
  static constexpr double high = kInf;
  static constexpr int seed = 0;
};
struct BentConfig : IdealConfig {
  static constexpr std::array<double, 1> scale = {2.0};
  static constexpr std::array<double, 2> bias = {0.5, -0.5};
  static constexpr std::array<double, 1> drift = {10.0};
  static constexpr double resolution = 0.25;
  static constexpr double low = -3.0;
};
struct NoisyConfig : IdealConfig {
  static constexpr std::array<double, 1> noise = {0.5};
  static constexpr double drop_out = 0.25;
};
struct EvenConfig : IdealConfig {
  static constexpr std::array<double, 2> spread = {0.5, 2.0};
};
template <class Real, class Config>
struct SensorIo : SignalIo<Real, Config, 2> {
  struct States {
    std::optional<V<float, 2>> bias{};
    std::optional<std::uint32_t> seed{};
  };
};
template <class Real>
using NoisyIo = SignalIo<Real, NoisyConfig, 2>;

// Of processors.
struct ConversionConfig {
  static constexpr std::array<double, 2> factor = {2.0, -0.1};
  static constexpr std::array<double, 1> offset = {0.1};
  static constexpr std::array<double, 1> low = {-1.0};
  static constexpr std::array<double, 2> high = {0.5, 2.0};
};
template <class RealType, class InputType, class OutputType = InputType>
struct ConversionIo {
  using Real = RealType;
  using Input = InputType;
  using Output = OutputType;
  using Config = ConversionConfig;
};

}  // namespace eagerx::models::testing::blocks

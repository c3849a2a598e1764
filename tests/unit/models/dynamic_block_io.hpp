// Io structs of blocks with memory, as the generator emits them.
#pragma once

#include <models/nodes/integrator/integrator.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>
#include <optional>

#include "tests/unit/models/block_io.hpp"

namespace eagerx::models::testing::blocks {

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

// Io structs of blocks without memory, as the generator emits them, and what all Io structs share.
#pragma once

#include <limits>
#include <models/nodes/lookup_table/lookup_table.hpp>
#include <models/nodes/reference/reference.hpp>
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

}  // namespace eagerx::models::testing::blocks

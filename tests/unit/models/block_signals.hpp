// Io structs and signals of long runs: slow constants, values far from 0.
#pragma once

#include <array>
#include <models/nodes/butterworth_filter/butterworth_filter.hpp>

#include "tests/unit/models/block_harness.hpp"
#include "tests/unit/models/entity_io.hpp"
#include "tests/unit/models/safety_io.hpp"

namespace eagerx::models::testing::long_runs {

using blocks::BlockIo;
using blocks::V;

constexpr std::uint64_t kHz = 1000;

/// In [-0.5, 0.5), another one for each tick and channel.
inline float even(Seq n, std::uint32_t channel) {
  const auto mixed = static_cast<std::uint32_t>(n * 2654435761U + channel * 40503U) * 2246822519U;
  return static_cast<float>(mixed >> 8U) / 16777216.0F - 0.5F;
}
/// Around `Offset`: a slow triangle of 10 and noise of 0.1.
template <int Offset>
struct Around {
  static float at(Seq n, std::uint32_t channel) {
    const Seq period = 60'000 + 1000 * static_cast<Seq>(channel);
    const auto place = static_cast<float>(n % period) / static_cast<float>(period);
    const float triangle = place < 0.5F ? 4.0F * place - 1.0F : 3.0F - 4.0F * place;
    return static_cast<float>(Offset) + 5.0F * triangle + 0.1F * even(n, channel);
  }
};
/// Of joints that are bent, and points within their reach.
struct Bent {
  static float at(Seq n, std::uint32_t channel) {
    return 0.45F + 0.04F * Around<0>::at(n, channel);
  }
};
/// Points around the hand of the arm [3], and a posture near them [4].
struct Reached {
  static float at(Seq n, std::uint32_t channel) {
    constexpr std::array<float, 7> kMiddle = {0.66F, 0.26F, 0.92F, -1.2F, -1.0F, 0.4F, 0.6F};
    return kMiddle[channel] + (channel < 3 ? 0.01F * Around<0>::at(n, channel) : 0.0F);
  }
};
/// Measurements of SwingIo of a pendulum that hangs and shakes: angles pi and its half. Where it
/// could go over the top, two filters could take different sides.
struct Hanging {
  static float at(Seq n, std::uint32_t channel) {
    const float middle = channel == 0 ? 3.1415927F : channel == 1 ? 1.5707964F : 0.0F;
    return middle + 0.01F * Around<0>::at(n, channel);
  }
};
/// Positions and velocities of two joints, both feet on the ground, and the inertial measurements
/// of a robot that stands and shakes.
struct Standing {
  static float at(Seq n, std::uint32_t channel) {
    const float shakes = 0.01F * Around<0>::at(n, channel);
    if (channel >= 6 && channel < 9) return 1.0F;
    return channel == 11 ? 9.81F + shakes : shakes;
  }
};
/// Rises every second tick.
struct Pulses {
  static float at(Seq n, std::uint32_t /*channel*/) { return static_cast<float>(n % 2); }
};

template <class Real, class Config>
using SignalIo = blocks::SignalIo<Real, Config, 1, 1, kHz>;
template <class Real, class Config>
struct FilteredIo : BlockIo<Real, Config, kHz> {
  struct Inputs {
    Skipped<V<Real>> signal;
  };
  struct Outputs {
    V<Real>& filtered;
  };
};
/// The same Io at 1 kHz with another configuration.
template <class Io, class ConfigType>
struct With : Io {
  using Config = ConfigType;
  using Rate = eagerx::Rate<kHz>;
};

template <FilterInitial Initial>
struct LowFilterConfig {
  static constexpr int order = 4;
  static constexpr auto type = FilterType::lowpass;
  static constexpr std::array<double, 1> cutoff_hz = {0.05};
  static constexpr auto initial = Initial;
};
struct FastFilterConfig : LowFilterConfig<FilterInitial::measured> {
  static constexpr std::array<double, 1> cutoff_hz = {60.0};
};
struct MeanConfig {
  static constexpr int n = 100'000;
  static constexpr auto initial = FilterInitial::zero;
};
struct FusionConfig {
  static constexpr double time_constant = 20.0;
  static constexpr double turn = 0.0;
};
struct MinuteConfig {  // Derivative, FirstOrderLag
  static constexpr double time_constant = 60.0;
  static constexpr double turn = 0.0;
};
struct LagConfig {
  static constexpr std::array<double, 1> time_constant = {60.0};
  static constexpr std::array<double, 1> initial = {290.0};
};
struct CountConfig {
  static constexpr double threshold = 0.5;
  static constexpr int modulo = 0;
};
/// scipy.signal.butter(2, 0.1, fs=1000)
struct LowTransferConfig {
  static constexpr std::array<double, 3> b = {9.865e-08, 1.973e-07, 9.865e-08};
  static constexpr std::array<double, 3> a = {1.0, -1.9991114235, 0.9991118181};
};
struct SumTransferConfig {
  static constexpr std::array<double, 2> b = {0.001, 0.0};
  static constexpr std::array<double, 2> a = {1.0, -1.0};
};
/// Two slow states and one that is the signal of the tick before.
struct SpaceConfig {
  static constexpr int order = 3;
  static constexpr std::array<double, 9> a = {0.99997, 0.0, 0.0, 0.00002, 0.99998, 0.0, 0, 0, 0};
  static constexpr std::array<double, 3> b = {0.00003, 0.0, 1.0};
  static constexpr std::array<double, 9> c = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  static constexpr std::array<double, 1> d = {0.0};
  static constexpr std::array<double, 1> initial = {0.0};
};
template <class Real>
using SpaceIo = blocks::SignalIo<Real, SpaceConfig, 1, 3, kHz>;
/// Position and speed, of which both are measured.
struct TrackConfig {
  static constexpr int order = 2;
  static constexpr std::array<double, 4> a = {1.0, 0.001, 0.0, 0.9999};
  static constexpr std::array<double, 4> b = {0.0, 0.0, 0.001, 0.0};
  static constexpr std::array<double, 4> c = {1.0, 0.0, 0.0, 1.0};
  static constexpr std::array<double, 2> initial = {290.0, 0.0};
  static constexpr std::array<double, 4> gain = {1e-4, 0.0, 0.0, 1e-4};
  static constexpr std::array<double, 2> q = {1e-8, 1e-8};
  static constexpr std::array<double, 2> r = {1.0, 1.0};
  static constexpr std::array<double, 2> p = {1.0, 1.0};
};
template <class Real>
struct TrackIo : BlockIo<Real, TrackConfig, kHz> {
  struct Inputs {
    Skipped<V<Real, 2>> measured;
    Skipped<V<Real, 2>> u;
  };
  struct Outputs {
    V<Real, 2>& x;
  };
};
template <class ModelIo>
struct SwingConfig : blocks::ExtendedConfig<ModelIo> {
  static constexpr std::array<double, 2> q = {1e-8, 1e-6};
  static constexpr std::array<double, 2> r = {1.0, 1.0};
};
template <class Real>
using SwingIo = With<blocks::ExtendedIo<Real>, SwingConfig<blocks::PendulumModelIo<Real>>>;
struct PidConfig : blocks::SetpointPidConfig {
  static constexpr double kp = 0.2;
  static constexpr double ki = 0.001;
  static constexpr double low = -1e6;
  static constexpr double high = 1e6;
};
template <ReferenceShape Shape>
struct LongReferenceConfig : blocks::ReferenceConfig<Shape> {
  static constexpr double frequency = 49.9;
  static constexpr double end_frequency = 80.0;
  static constexpr double duration = 100'000.0;
  static constexpr std::array<double, 5> times = {0.0, 60'000.0, 67'108.85, 67'108.87, 90'000.0};
  static constexpr std::array<double, 5> values = {0.0, 1.0, -1.0, 1.0, 0.0};
};
struct DriftConfig : blocks::IdealConfig {
  static constexpr std::array<double, 1> drift = {0.001};
};
struct SlewConfig {
  static constexpr std::array<double, 1> per_second = {0.01};
  static constexpr std::array<double, 1> initial = {290.0};
};
struct OneDelayConfig : blocks::DelayConfig {
  static constexpr double delay = 0.0123;
  static constexpr double max_delay = 0.02;
};

// Io structs of vectors for blocks whose messages may be numbers.
template <class Real>
using LimitsOfActionIo = ActionLimitsIo<Real, V<Real>>;
template <class Real>
using SlewIo = With<SlewLimitIo<Real, V<Real>>, SlewConfig>;
template <class Real>
using GuardIo = NanGuardIo<Real, V<Real>>;
template <class Real>
using ChoiceIo = PlainFallbackIo<Real, V<Real>>;
template <class Real>
struct ToAngleIo : ResetAngleIo<Real> {
  struct Inputs {
    Skipped<Real> theta;
    Skipped<Real> theta_dot;
  };
};
template <class Real>
struct ToDecomposedAngleIo : ResetAngleIo<Real> {
  struct Inputs {
    Skipped<V<Real, 3>> x;
  };
};
/// With one sample in its window: what of the others there is, is not kept.
template <class Real>
struct WindowIo : BlockIo<Real, Low2> {
  struct Config : Low2 {
    static constexpr int index = 0;
    static constexpr int N = 2;
    static constexpr std::array<double, 1> Wn = {10.0};
    static constexpr auto btype = FilterType::lowpass;
  };
  struct Inputs {
    Window<V<Real>, eagerx::Rate<100>, 1, 2, false> signal;
  };
  struct Outputs {
    V<Real>& filtered;
  };
};

}  // namespace eagerx::models::testing::long_runs

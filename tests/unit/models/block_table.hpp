// Every block of the library: how far float may be from double in a long run, and what one NaN
// does. A block that is not here fails BlockTable.HasEveryBlockOfTheLibrary.
#pragma once

#include <algorithm>
#include <models/nodes/action_limits/action_limits.hpp>
#include <models/nodes/backlash/backlash.hpp>
#include <models/nodes/body_motion/body_motion.hpp>
#include <models/nodes/complementary_filter/complementary_filter.hpp>
#include <models/nodes/computed_torque/computed_torque.hpp>
#include <models/nodes/constant/constant.hpp>
#include <models/nodes/counter/counter.hpp>
#include <models/nodes/dead_zone/dead_zone.hpp>
#include <models/nodes/demux/demux.hpp>
#include <models/nodes/derivative/derivative.hpp>
#include <models/nodes/difference/difference.hpp>
#include <models/nodes/discrete_transfer_function/discrete_transfer_function.hpp>
#include <models/nodes/extended_kalman_filter/extended_kalman_filter.hpp>
#include <models/nodes/fallback_controller/fallback_controller.hpp>
#include <models/nodes/first_order_lag/first_order_lag.hpp>
#include <models/nodes/floating_base_observer/floating_base_observer.hpp>
#include <models/nodes/forward_kinematics/forward_kinematics.hpp>
#include <models/nodes/gain/gain.hpp>
#include <models/nodes/gravity_compensation/gravity_compensation.hpp>
#include <models/nodes/integrator/integrator.hpp>
#include <models/nodes/inverse_dynamics/inverse_dynamics.hpp>
#include <models/nodes/inverse_kinematics/inverse_kinematics.hpp>
#include <models/nodes/jacobian/jacobian.hpp>
#include <models/nodes/kalman_filter/kalman_filter.hpp>
#include <models/nodes/lookup_table/lookup_table.hpp>
#include <models/nodes/lookup_table_2d/lookup_table_2d.hpp>
#include <models/nodes/matrix_gain/matrix_gain.hpp>
#include <models/nodes/moving_average_filter/moving_average_filter.hpp>
#include <models/nodes/moving_median/moving_median.hpp>
#include <models/nodes/mux/mux.hpp>
#include <models/nodes/nan_guard/nan_guard.hpp>
#include <models/nodes/observer/observer.hpp>
#include <models/nodes/operational_space/operational_space.hpp>
#include <models/nodes/pid_controller/pid_controller.hpp>
#include <models/nodes/product/product.hpp>
#include <models/nodes/quantizer/quantizer.hpp>
#include <models/nodes/reference/reference.hpp>
#include <models/nodes/reset_angle/reset_angle.hpp>
#include <models/nodes/reset_decomposed_angle/reset_decomposed_angle.hpp>
#include <models/nodes/saturation/saturation.hpp>
#include <models/nodes/sensor_model/sensor_model.hpp>
#include <models/nodes/slew_limit/slew_limit.hpp>
#include <models/nodes/state_feedback/state_feedback.hpp>
#include <models/nodes/state_space/state_space.hpp>
#include <models/nodes/sum/sum.hpp>
#include <models/nodes/switch/switch.hpp>
#include <models/nodes/transport_delay/transport_delay.hpp>
#include <models/nodes/unit_delay/unit_delay.hpp>
#include <models/nodes/windowed_butterworth/windowed_butterworth.hpp>
#include <string_view>

#include "tests/unit/models/block_signals.hpp"
#include "tests/unit/multibody/robot_block_io.hpp"

namespace eagerx::models::testing::long_runs {

/// The answer of a block to signals in which one message is wrong.
struct Answer {
  bool shows;     // an output was not finite within the ticks that a NaN may stay
  bool recovers;  // afterwards every output was finite
};
struct Row {
  std::string_view folder;  // in models/nodes
  std::string_view what;
  double bound;  // of |float − double|/max(1, |double|)
  /// The largest error from tick `first` on.
  double (*error)(Seq first, Seq ticks);
  /// Of input `wrong_input`, which is `wrong` at one tick.
  Answer (*answer)(float wrong, std::size_t wrong_input);
  /// Calls the block in float `ticks` times, with the same messages: for tests/bench/blocks.
  void (*spend)(Seq ticks);
  std::size_t bytes;  // of the block in float
  std::size_t inputs;
  int stays = 0;  // ticks for which a wrong number may be seen after it
};

/// A message, or its only element where an input is a number.
template <class Message>
struct From {
  const Message* message;
  operator const Message*() const { return message; }                   // NOLINT
  operator const ScalarOf<Message>*() const { return &(*message)[0]; }  // NOLINT
};

/// A node with messages of N... elements as inputs.
template <template <class> class Node, class Io, std::size_t... N>
struct Bench {
  using Real = typename Io::Real;
  Node<Io> node{};
  std::tuple<V<Real, N>...> messages{};

  Bench() { node.reset({}); }

  /// f(element, input, index) writes each element of the messages; f(output element) reads.
  template <class Write, class Read>
  void tick(Seq n, const Write& write, const Read& read) {
    std::uint32_t input = 0;
    const auto fill = [&](auto& message) {
      for (std::size_t i = 0; i < message.size(); ++i) write(message[i], input, i);
      ++input;
    };
    std::apply([&](auto&... message) { (fill(message), ...); }, messages);
    std::apply([&](auto&... message) { call(n, read, message...); }, messages);
  }

 private:
  template <class Read, class... Message>
  void call(Seq n, const Read& read, const Message&... message) {
    const typename Io::Inputs in{{From<Message>{&message}, 1, 1}...};
    if constexpr (requires(typename Io::Outputs out) { out.c; }) {  // Demux
      V<Real, 2> b{};
      V<Real> c{};
      typename Io::Outputs out{b, c};
      node.callback(Tick{n}, in, out);
      for (const auto& x : b) read(x);
      read(c[0]);
    } else if constexpr (requires(typename Io::Outputs out) { out.attitude; }) {
      V<Real, 4> attitude{};
      V<Real, 3> velocity{}, angular_velocity{}, gravity{};
      typename Io::Outputs out{attitude, velocity, angular_velocity, gravity};
      node.callback(Tick{n}, in, out);
      // Nothing measures the heading, so roundings add up in it; `gravity` has roll and pitch.
      Real square(0);
      for (const auto& x : attitude) square += x * x;
      read(square);
      for (const auto* vector : {&velocity, &angular_velocity, &gravity}) {
        for (const auto& x : *vector) read(x);
      }
    } else if constexpr (requires(typename Io::Outputs out) { out.gravity; }) {  // BodyMotion
      std::array<V<Real, 3>, 3> vectors{};
      typename Io::Outputs out{vectors[0], vectors[1], vectors[2]};
      node.callback(Tick{n}, in, out);
      for (const auto& vector : vectors) {
        for (const auto& x : vector) read(x);
      }
    } else {
      Output y{};
      typename Io::Outputs out{y};
      run(n, in, out);
      for (const auto& x : y) read(x);
    }
  }
  void run(Seq n, const typename Io::Inputs& in, typename Io::Outputs& out) {
    if constexpr (requires { typename Io::Targets; }) {  // reset nodes
      typename Io::Targets targets{.goal = {{3.0F, 0.0F}}};
      typename Io::Done done{};
      node.callback(Tick{n}, in, targets, out, done);
    } else {
      node.callback(Tick{n}, in, out);
    }
  }
  /// In an unevaluated expression only.
  static auto output(typename Io::Outputs& out) {
    if constexpr (
        requires { out.c; } || requires { out.gravity; }) {
      return std::type_identity<int>{};
    } else {
      auto& [first] = out;
      return std::type_identity<std::remove_cvref_t<decltype(first)>>{};
    }
  }
  using Output = typename decltype(output(std::declval<typename Io::Outputs&>()))::type;
};

template <template <class> class Node, template <class> class Io, class Signal, std::size_t... N>
double error_of(Seq first, Seq ticks) {
  Bench<Node, Io<float>, N...> single;
  Bench<Node, Io<double>, N...> twice;
  double worst = 0.0;
  std::array<double, 24> found{};
  for (Seq n = first; n < first + ticks; ++n) {
    const auto write = [n](auto& x, std::uint32_t input, std::size_t i) {
      x = static_cast<std::remove_reference_t<decltype(x)>>(
          Signal::at(n, 3 * input + static_cast<std::uint32_t>(i)));
    };
    std::size_t count = 0;
    single.tick(n, write, [&](auto x) { found[count++] = static_cast<double>(x); });
    count = 0;
    twice.tick(n, write, [&](auto x) {
      const auto right = static_cast<double>(x);
      const double error = std::abs(found[count++] - right) / std::max(1.0, std::abs(right));
      worst = error <= worst ? worst : error;  // NaN is the worst
    });
  }
  return worst;
}

template <template <class> class Node, template <class> class Io, class Signal, int Stays,
          std::size_t... N>
Answer answer_of(float wrong, std::size_t wrong_input) {
  Bench<Node, Io<float>, N...> bench;
  Answer answer{false, true};
  constexpr Seq kWrong = 20;
  for (Seq n = 0; n < 100; ++n) {
    const auto write = [&](auto& x, std::uint32_t input, std::size_t i) {
      const bool now = n == kWrong && input == wrong_input;
      x = now ? wrong : Signal::at(n, 3 * input + static_cast<std::uint32_t>(i));
    };
    bench.tick(n, write, [&](float x) {
      if (std::isfinite(x)) return;
      const bool may = n >= kWrong && n <= kWrong + static_cast<Seq>(Stays);
      answer.shows = answer.shows || may;
      answer.recovers = answer.recovers && may;
    });
  }
  return answer;
}

template <template <class> class Node, template <class> class Io, class Signal, std::size_t... N>
void spend_on(Seq ticks) {
  Bench<Node, Io<float>, N...> bench;
  [[maybe_unused]] volatile float sink = 0.0F;
  for (Seq n = 0; n < ticks; ++n) {
    const auto write = [n](float& x, std::uint32_t input, std::size_t /*i*/) {
      if (n == 0) x = Signal::at(1, input);
    };
    bench.tick(n, write, [&](float x) { sink = x; });
  }
}

template <template <class> class Node, template <class> class Io, class Signal, int Stays,
          std::size_t... N>
constexpr Row row(std::string_view folder, std::string_view what, double bound) {
  return {folder,
          what,
          bound,
          &error_of<Node, Io, Signal, N...>,
          &answer_of<Node, Io, Signal, Stays, N...>,
          &spend_on<Node, Io, Signal, N...>,
          sizeof(Node<Io<float>>),
          sizeof...(N),
          Stays};
}

using Far = Around<300>;
using Near = Around<0>;
template <class Real>
struct MotionIo : blocks::BlockIo<Real, NoConfig> {
  struct Inputs {
    Skipped<V<Real, 7>> pose;
    Skipped<V<Real, 6>> twist;
  };
  struct Outputs {
    V<Real, 3>&velocity, &angular_velocity, &gravity;
  };
};
template <class Real>
using BacklashIo = SignalIo<Real, blocks::PlayConfig>;
template <class Real>
using LowIo = FilteredIo<Real, LowFilterConfig<FilterInitial::zero>>;
template <class Real>
using LowMeasuredIo = FilteredIo<Real, LowFilterConfig<FilterInitial::measured>>;
template <class Real>
using FastIo = FilteredIo<Real, FastFilterConfig>;
template <class Real>
using AverageIo = FilteredIo<Real, MeanConfig>;
template <class Real>
using FusionIo = With<blocks::ComplementaryIoOf<Real, FusionConfig>, FusionConfig>;
template <class Real>
using SlopeIo = SignalIo<Real, MinuteConfig>;
template <class Real>
using DirectSlopeIo = SignalIo<Real, blocks::NoFilterConfig>;
template <class Real>
using SlowLagIo = SignalIo<Real, LagConfig>;
template <class Real>
using CountIo = SignalIo<Real, CountConfig>;
template <class Real>
using LowTransferIo = SignalIo<Real, LowTransferConfig>;
template <class Real>
using SumTransferIo = SignalIo<Real, SumTransferConfig>;
template <class Real>
using DifferenceIo = With<blocks::AngleIo<Real>, blocks::DifferenceConfig>;
template <class Real>
using ConstantIo = blocks::SourceIo<Real, blocks::ConstantConfig>;
template <class Real>
using PidIo = With<blocks::SetpointPidIo<Real>, PidConfig>;
template <class Real>
using SineIo = With<ConstantIo<Real>, LongReferenceConfig<ReferenceShape::sine>>;
template <class Real>
using ChirpIo = With<ConstantIo<Real>, LongReferenceConfig<ReferenceShape::chirp>>;
template <class Real>
using RampIo = With<ConstantIo<Real>, LongReferenceConfig<ReferenceShape::ramp>>;
template <class Real>
using CurveIo = With<ConstantIo<Real>, LongReferenceConfig<ReferenceShape::table>>;
template <class Real>
using DriftIo = SignalIo<Real, DriftConfig>;
template <class Real>
using DelayIo = SignalIo<Real, OneDelayConfig>;

template <class Real>
using ArmConfig = robots::MixedConfig<robots::MixedArm<Real>>;
template <class Real>
using LegsIo = robots::ObserverIo<Real, robots::ObserverConfig<robots::TwoLegs<Real>>, 2, 2,
                                  eagerx::Rate<kHz>>;
template <class Real>
using ArmDynamicsIo = robots::DynamicsIo<Real, ArmConfig<Real>, 4>;
template <class Real>
using ArmGravityIo = robots::GravityIo<Real, ArmConfig<Real>, 4>;
template <class Real>
using ArmComputedIo = robots::ComputedIo<Real, ArmConfig<Real>, 4>;
template <class Real>
using ArmForwardIo = robots::ForwardIo<Real, ArmConfig<Real>, 4>;
template <class Real>
using ArmJacobianIo = robots::JacobianIo<Real, ArmConfig<Real>, 4>;
template <class Real>
using ArmInverseIo = robots::PosturedInverseIo<Real, ArmConfig<Real>, 4, 3>;
template <class Real>
using ArmHandIo = robots::OperationalIo<Real, robots::HandConfig<robots::MixedArm<Real>>, 4, 3>;

/// Bounds of 1e-5 and more have a reason: sums without a limit keep what each product is rounded
/// by, slow filters divide the roundings of P by their gain, phases have the digits of float within
/// a second times the frequency, and a derivative within the PID controllers divides by the period.
/// Torques are sums of terms that are a hundred times as large. The search of InverseKinematics
/// begins at one posture: from its last q, roundings move the joint that the goal leaves free. The
/// feet of FloatingBaseObserver say little of the gyroscope's bias about the vertical. Quaternions
/// of BodyMotion are of any length here, so that it, too, adds terms far larger than their sum.
inline constexpr std::array kBlocks = {
    row<ActionLimits, LimitsOfActionIo, Near, 0, 1>("action_limits", "", 0.0),
    row<Backlash, BacklashIo, Far, 0, 1>("backlash", "", 1e-7),
    row<BodyMotion, MotionIo, Near, 0, 7, 6>("body_motion", "", 1e-4),
    row<ButterworthFilter, LowIo, Far, 0, 1>("butterworth_filter", "0.05 Hz", 1e-6),
    row<ButterworthFilter, LowMeasuredIo, Far, 0, 1>("butterworth_filter", "measured", 1e-6),
    row<ButterworthFilter, FastIo, Far, 0, 1>("butterworth_filter", "60 Hz", 5e-6),
    row<ComplementaryFilter, FusionIo, Near, 0, 1, 1>("complementary_filter", "20 s", 1e-6),
    row<ComputedTorque, ArmComputedIo, Bent, 0, 4, 4, 4, 4, 4>("computed_torque", "", 1e-5),
    row<Constant, ConstantIo, Near, 0>("constant", "", 0.0),
    row<Counter, CountIo, Pulses, 0, 1>("counter", "", 1e-7),
    row<DeadZone, blocks::LimitsIo, Near, 0, 2>("dead_zone", "", 1e-7),
    row<Demux, blocks::DemuxIo, Near, 0, 4>("demux", "", 0.0),
    row<Derivative, SlopeIo, Far, 0, 1>("derivative", "60 s", 1e-6),
    row<Derivative, DirectSlopeIo, Far, 0, 1>("derivative", "no filter", 1e-6),
    row<Difference, DifferenceIo, Near, 0, 1, 1>("difference", "", 1e-6),
    row<DiscreteTransferFunction, LowTransferIo, Far, 0, 1>("discrete_transfer_function", "0.1 Hz",
                                                            2e-6),
    row<DiscreteTransferFunction, SumTransferIo, Near, 0, 1>("discrete_transfer_function", "sum",
                                                             1e-5),
    row<ExtendedKalmanFilter, SwingIo, Hanging, 0, 2, 1>("extended_kalman_filter", "", 1e-3),
    row<FallbackController, ChoiceIo, Near, 0, 1, 1>("fallback_controller", "", 0.0),
    row<FirstOrderLag, SlowLagIo, Far, 0, 1>("first_order_lag", "60 s", 1e-6),
    row<FloatingBaseObserver, LegsIo, Standing, 0, 2, 2, 2, 6>("floating_base_observer", "", 1e-4),
    row<ForwardKinematics, ArmForwardIo, Near, 0, 4>("forward_kinematics", "", 4e-6),
    row<Gain, blocks::GainIo, Far, 0, 2>("gain", "", 1e-7),
    row<GravityCompensation, ArmGravityIo, Near, 0, 4>("gravity_compensation", "", 2e-5),
    row<Integrator, blocks::BackwardIo, Near, 0, 1>("integrator", "backward", 1e-5),
    row<Integrator, blocks::ForwardIo, Far, 0, 1>("integrator", "forward", 1e-6),
    row<Integrator, blocks::TrapezoidalIo, Far, 0, 1>("integrator", "trapezoidal", 1e-6),
    row<InverseDynamics, ArmDynamicsIo, Near, 0, 4, 4, 4>("inverse_dynamics", "", 2e-4),
    row<InverseKinematics, ArmInverseIo, Reached, 0, 3, 4>("inverse_kinematics", "", 5e-6),
    row<Jacobian, ArmJacobianIo, Near, 0, 4>("jacobian", "", 4e-6),
    row<KalmanFilter, TrackIo, Far, 0, 2, 2>("kalman_filter", "", 2e-4),
    row<LookupTable, blocks::TableIo, Near, 0, 1>("lookup_table", "", 1e-6),
    row<LookupTable2d, blocks::GridIo, Near, 0, 1, 1>("lookup_table_2d", "", 1e-6),
    row<MatrixGain, blocks::MatrixIo, Far, 0, 2>("matrix_gain", "", 1e-6),
    row<MovingAverageFilter, AverageIo, Far, 0, 1>("moving_average_filter", "100 s", 1e-6),
    row<MovingMedian, blocks::MedianIo, Far, 0, 1>("moving_median", "", 1e-7),
    row<Mux, blocks::MuxIo, Near, 0, 1, 3>("mux", "", 0.0),
    row<NanGuard, GuardIo, Near, 0, 1>("nan_guard", "", 0.0),
    row<Observer, TrackIo, Far, 0, 2, 2>("observer", "", 1e-5),
    row<OperationalSpace, ArmHandIo, Bent, 0, 4, 4, 3, 3, 3>("operational_space", "", 1e-4),
    row<PidController, PidIo, Far, 0, 1, 1, 1>("pid_controller", "", 1e-5),
    row<Product, blocks::ProductIo, Far, 0, 2, 2>("product", "", 1e-7),
    row<Quantizer, blocks::QuantizerIo, Far, 0, 1>("quantizer", "", 0.0),
    row<eagerx::models::Reference, SineIo, Near, 0>("reference", "sine", 1e-4),
    row<eagerx::models::Reference, ChirpIo, Near, 0>("reference", "chirp", 2e-4),
    row<eagerx::models::Reference, RampIo, Near, 0>("reference", "ramp", 1e-6),
    row<eagerx::models::Reference, CurveIo, Near, 0>("reference", "table", 3e-5),
    row<ResetAngle, ToAngleIo, Near, 0, 1, 1>("reset_angle", "", 1e-4),
    row<ResetDecomposedAngle, ToDecomposedAngleIo, Near, 0, 3>("reset_decomposed_angle", "", 1e-4),
    row<Saturation, blocks::LimitsIo, Near, 0, 2>("saturation", "", 0.0),
    row<SensorModel, DriftIo, Far, 0, 1>("sensor_model", "drift", 1e-6),
    row<SlewLimit, SlewIo, Far, 0, 1>("slew_limit", "0.01/s", 1e-6),
    row<StateFeedback, blocks::FeedbackIo, Near, 0, 2, 1>("state_feedback", "", 1e-6),
    row<StateSpace, SpaceIo, Far, 0, 1>("state_space", "", 2e-6),
    row<Sum, blocks::SumIo, Near, 0, 2, 2, 2>("sum", "", 1e-6),
    row<Switch, blocks::SwitchIo, Near, 0, 1, 2, 2>("switch", "", 0.0),
    row<TransportDelay, DelayIo, Far, 13, 1>("transport_delay", "", 3e-6),
    row<UnitDelay, blocks::UnitIo, Far, 1, 1>("unit_delay", "", 0.0),
    row<WindowedButterworth, WindowIo, Near, 0, 1>("windowed_butterworth", "", 0.0),
};

/// Folders of models/nodes whose manifests have no numbers as inputs, or no class of their own, or
/// that are about one episode.
inline constexpr std::array<std::string_view, 6> kNoBlocks = {
    "cascade_controller",                     // a composite of blocks
    "rasterizer",         "grey_rasterizer",  // take drawings
    "walking_commands",   "pushes",           // sampled when an episode begins, and have no inputs
    "speed_errors",  // means over an episode, which keep a NaN until it ends
};

}  // namespace eagerx::models::testing::long_runs

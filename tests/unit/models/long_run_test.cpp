// Blocks in float after hours: sums that must not stall, phases that must not drift, estimates that
// must keep their digits. The right value is a closed form, or the same block in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <models/nodes/butterworth_filter/butterworth_filter.hpp>
#include <models/nodes/derivative/derivative.hpp>
#include <models/nodes/first_order_lag/first_order_lag.hpp>
#include <models/nodes/integrator/integrator.hpp>
#include <models/nodes/kalman_filter/kalman_filter.hpp>
#include <models/nodes/moving_average_filter/moving_average_filter.hpp>
#include <models/nodes/pid_controller/pid_controller.hpp>
#include <models/nodes/reference/reference.hpp>
#include <models/nodes/slew_limit/slew_limit.hpp>
#include <optional>

#include "tests/unit/models/block_harness.hpp"

namespace eagerx::models::testing {
namespace {

using blocks::Ticking;
using blocks::V;

/// A filter whose output is called `filtered` (or `limited`), after `ticks` of a constant signal.
template <class Node, class Outputs, class Real>
Real after(Node& node, const V<Real>& signal, std::uint64_t ticks, std::uint64_t first = 0) {
  V<Real> y{};
  Outputs out{y};
  for (std::uint64_t n = first; n < first + ticks; ++n) node.callback({n}, {{&signal, 1, 1}}, out);
  return y[0];
}

template <class RealType, class ConfigType, class RateType = eagerx::Rate<1000>>
struct FilteredIo {
  using Real = RealType;
  using Config = ConfigType;
  using Rate = RateType;
  using States = NoStates;
  struct Inputs {
    Skipped<V<Real>> signal;
  };
  struct Outputs {
    V<Real>& filtered;
  };
};
template <class RealType, class ConfigType>
struct LimitedIo : FilteredIo<RealType, ConfigType> {
  struct Outputs {
    V<RealType>& limited;
  };
};

template <int From>
struct SlowConfig {
  static constexpr std::array<double, 1> per_second = {0.01};
  static constexpr std::array<double, 1> initial = {From};
};

TEST(LongRun, SlewLimitMovesHoweverSlowly) {
  using High = LimitedIo<float, SlowConfig<300>>;
  SlewLimit<High> high;
  high.reset({});
  EXPECT_NEAR((after<SlewLimit<High>, High::Outputs, float>(high, {{310.0F}}, 1'000'000)), 310.0F,
              1e-4F);
  using Low = LimitedIo<float, SlowConfig<130>>;
  SlewLimit<Low> low;
  low.reset({});
  // Faster than it may is worse than slower.
  EXPECT_NEAR((after<SlewLimit<Low>, Low::Outputs, float>(low, {{310.0F}}, 1'000'000)), 140.0F,
              1e-4F);
}

struct FreeConfig {
  static constexpr auto method = IntegrationMethod::backward;
  static constexpr std::array<double, 1> initial = {0.0};
  static constexpr std::array<double, 1> low = {-blocks::kInf};
  static constexpr std::array<double, 1> high = {blocks::kInf};
};
struct OddRateIo : blocks::SignalIo<float, FreeConfig> {
  using Rate = eagerx::Rate<1000, 7>;
};

TEST(LongRun, IntegratorOfOneIsTheTime) {
  Ticking<Integrator, OddRateIo> node;
  float y = 0.0F;
  for (int n = 0; n < 142'857; ++n) y = node(V<float>{{1.0F}})[0];
  EXPECT_NEAR(y, 142'857 * 0.007, 1e-4);
}

struct MinuteConfig {
  static constexpr std::array<double, 1> time_constant = {60.0};
  static constexpr std::array<double, 1> initial = {0.0};
};

TEST(LongRun, FirstOrderLagArrives) {
  Ticking<FirstOrderLag, blocks::SignalIo<float, MinuteConfig, 1, 1, 1000>> node;
  float y = 0.0F;
  for (int n = 0; n < 1'200'000; ++n) y = node(V<float>{{310.0F}})[0];
  EXPECT_NEAR(y, 310.0 * (1.0 - std::exp(-20.0)), 1e-4);
}

struct MillionConfig {
  static constexpr int n = 100'000;
  static constexpr auto initial = FilterInitial::zero;
};

TEST(LongRun, MovingAverageArrives) {
  using Io = FilteredIo<float, MillionConfig>;
  MovingAverageFilter<Io> node;
  node.reset({});
  EXPECT_NEAR((after<MovingAverageFilter<Io>, Io::Outputs, float>(node, {{310.0F}}, 2'000'000)),
              310.0 * (1.0 - std::pow(1.0 - 1e-5, 2e6)), 1e-4);
}

struct HumConfig : blocks::ReferenceConfig<ReferenceShape::sine> {
  static constexpr double amplitude = 1.0;
  static constexpr double offset = 0.0;
  static constexpr double start = 0.0;
  static constexpr double frequency = 50.0;
};
struct TunedHumConfig : HumConfig {
  static constexpr double frequency = 49.9;
};
template <class RealType, class ConfigType, class RateType>
struct SourceAtIo : blocks::SourceIo<RealType, ConfigType> {
  using Rate = RateType;
};

/// The largest error of a sine over 2,000 ticks from `first` on.
template <class Io>
double error_of_sine(std::uint64_t first, double frequency) {
  eagerx::models::Reference<Io> node;
  node.reset({});
  double worst = 0.0;
  for (std::uint64_t n = first; n < first + 2000; ++n) {
    V<typename Io::Real> y{};
    typename Io::Outputs out{y};
    node.callback(Tick{n}, {}, out);
    // Ten seconds times the denominator are whole turns of both frequencies.
    const auto turns =
        static_cast<long double>(frequency) * static_cast<long double>(n % (10 * Io::Rate::num)) *
        static_cast<long double>(Io::Rate::den) / static_cast<long double>(Io::Rate::num);
    const double right =
        static_cast<double>(std::sin(2.0L * 3.14159265358979323846L * (turns - std::floor(turns))));
    worst = std::max(worst, std::abs(static_cast<double>(y[0]) - right));
  }
  return worst;
}

TEST(LongRun, SinesKeepTheirPhase) {
  for (const std::uint64_t first : {0ULL, 600'000ULL, 3'600'000ULL, 16'920'000ULL, 1ULL << 32}) {
    EXPECT_LT((error_of_sine<SourceAtIo<float, HumConfig, eagerx::Rate<1000>>>(first, 50.0)), 5e-5)
        << first;
    EXPECT_LT(
        (error_of_sine<SourceAtIo<float, TunedHumConfig, eagerx::Rate<1000, 7>>>(first, 49.9)),
        5e-5)
        << first;
    EXPECT_LT((error_of_sine<SourceAtIo<double, HumConfig, eagerx::Rate<1000>>>(first, 50.0)),
              1e-12)
        << first;
  }
}

struct SweepConfig : HumConfig {
  static constexpr auto shape = ReferenceShape::chirp;
  static constexpr double frequency = 1.0;
  static constexpr double end_frequency = 30.0;
  static constexpr double duration = 10.0;
};

TEST(LongRun, AChirpGoesOnWithItsLastFrequency) {
  using Io = SourceAtIo<float, SweepConfig, eagerx::Rate<1000>>;
  eagerx::models::Reference<Io> node;
  node.reset({});
  for (const std::uint64_t n :
       {4'000ULL, 9'999ULL, 10'000ULL, 10'001ULL, 12'345ULL, 36'000'017ULL}) {
    V<float> y{};
    Io::Outputs out{y};
    node.callback(Tick{n}, {}, out);
    const double t = static_cast<double>(n) / 1000.0;
    const double sweep = std::min(t, 10.0);
    const double turns = sweep + 29.0 * sweep * sweep / 20.0 + 30.0 * (t - sweep);
    EXPECT_NEAR(static_cast<double>(y[0]), std::sin(2.0 * M_PI * (turns - std::floor(turns))), 2e-4)
        << n;
  }
}

template <FilterType Type, int Order, int CornerMicroHz>
struct CornerConfig {
  static constexpr auto initial = FilterInitial::zero;
  static constexpr auto type = Type;
  static constexpr int order = Order;
  static constexpr std::array<double, 1> cutoff_hz = {CornerMicroHz * 1e-6};
};

/// The largest relative error over time in float against double, of steps up and down.
template <class Config, class Rate>
double error_of_filter(std::uint64_t ticks) {
  using Single = FilteredIo<float, Config, Rate>;
  using Double = FilteredIo<double, Config, Rate>;
  ButterworthFilter<Single> single;
  ButterworthFilter<Double> twice;
  single.reset({});
  twice.reset({});
  double worst = 0.0;
  for (std::uint64_t n = 0; n < ticks; ++n) {
    const bool up = n < ticks / 2;
    const V<float> one{{up ? 1.0F : -0.5F}};
    const V<double> two{{up ? 1.0 : -0.5}};
    worst = std::max(
        worst,
        std::abs(
            static_cast<double>(
                after<ButterworthFilter<Single>, typename Single::Outputs, float>(single, one, 1)) -
            after<ButterworthFilter<Double>, typename Double::Outputs, double>(twice, two, 1)));
  }
  return worst;
}

TEST(LongRun, ButterworthKeepsItsGainAtLowCorners) {
  using Slow = eagerx::Rate<50>;
  EXPECT_LT((error_of_filter<CornerConfig<FilterType::lowpass, 8, 1000>, Slow>(400'000)), 1e-5);
  EXPECT_LT((error_of_filter<CornerConfig<FilterType::lowpass, 2, 5000>, Slow>(200'000)), 1e-5);
  EXPECT_LT((error_of_filter<CornerConfig<FilterType::lowpass, 3, 5000>, Slow>(200'000)), 1e-5);
  EXPECT_LT((error_of_filter<CornerConfig<FilterType::highpass, 4, 5000>, Slow>(200'000)), 1e-5);
  using Io = FilteredIo<float, CornerConfig<FilterType::lowpass, 8, 1000>, Slow>;
  ButterworthFilter<Io> node;
  node.reset({});
  EXPECT_NEAR((after<ButterworthFilter<Io>, Io::Outputs, float>(node, {{1.0F}}, 600'000)), 1.0,
              1e-5);
}

TEST(LongRun, BothFormsOfAButterworthFilterAreOneFilter) {
  // A corner at a fiftieth of the rate is the last one of the direct form; in double both agree.
  using Rate = eagerx::Rate<1000>;
  using Io = FilteredIo<double, CornerConfig<FilterType::lowpass, 5, 19'999'999>, Rate>;
  using Direct = FilteredIo<double, CornerConfig<FilterType::lowpass, 5, 20'000'000>, Rate>;
  ButterworthFilter<Io> node;
  ButterworthFilter<Direct> direct;
  node.reset({});
  direct.reset({});
  static_assert(ButterworthSections<Io>::kIsLow && !ButterworthSections<Direct>::kIsLow);
  for (int n = 0; n < 2000; ++n) {
    const V<double> x{{std::sin(0.01 * n) + (n > 300 ? 1.0 : 0.0)}};
    EXPECT_NEAR((after<ButterworthFilter<Io>, Io::Outputs, double>(node, x, 1)),
                (after<ButterworthFilter<Direct>, Direct::Outputs, double>(direct, x, 1)), 1e-7);
  }
}

template <class Node, class Outputs, class Real>
void expect_recovers(Node& node) {
  const Real nan = blocks::kNan<Real>;
  after<Node, Outputs, Real>(node, {{Real(1)}}, 50);
  EXPECT_TRUE(std::isnan((after<Node, Outputs, Real>(node, {{nan}}, 1))))
      << "a fault stays visible";
  const Real inf = std::numeric_limits<Real>::infinity();
  EXPECT_EQ((after<Node, Outputs, Real>(node, {{inf}}, 1)), inf);
  EXPECT_NEAR((after<Node, Outputs, Real>(node, {{Real(1)}}, 500)), Real(1), Real(1e-4));
}

struct TenConfig {
  static constexpr int n = 10;
  static constexpr auto initial = FilterInitial::zero;
};

struct WrappingConfig {
  static constexpr double time_constant = 0.0;
  static constexpr double turn = 2.0 * M_PI;
};

TEST(Derivative, OfAnAngleThatWraps) {
  Ticking<Derivative, blocks::SignalIo<double, WrappingConfig>> node;
  for (int n = 0; n < 1000; ++n) {
    const double angle = std::remainder(0.5 * n, 2.0 * M_PI);
    const double y = node(V<double>{{angle}})[0];
    EXPECT_NEAR(y, n == 0 ? 0.0 : 50.0, 1e-10) << n;
  }
}

TEST(Filters, OneNanIsOver) {
  using Fast = FilteredIo<float, CornerConfig<FilterType::lowpass, 2, 100'000'000>>;
  ButterworthFilter<Fast> fast;
  fast.reset({});
  expect_recovers<ButterworthFilter<Fast>, Fast::Outputs, float>(fast);
  using Slow = FilteredIo<float, CornerConfig<FilterType::lowpass, 2, 15'000'000>>;
  ButterworthFilter<Slow> slow;
  slow.reset({});
  expect_recovers<ButterworthFilter<Slow>, Slow::Outputs, float>(slow);
  using Mean = FilteredIo<float, TenConfig>;
  MovingAverageFilter<Mean> mean;
  mean.reset({});
  expect_recovers<MovingAverageFilter<Mean>, Mean::Outputs, float>(mean);
}

/// Position, speed and acceleration at 100 Hz, with a position that is measured.
template <int Exponent>
struct TrackConfig {
  static constexpr int order = 3;
  static constexpr std::array<double, 9> a = {1, 0.01, 0.00005, 0, 1, 0.01, 0, 0, 1};
  static constexpr std::array<double, 0> b = {};
  static constexpr std::array<double, 3> c = {1, 0, 0};
  static constexpr std::array<double, 1> initial = {0.0};
  static constexpr std::array<double, 3> q = {0.0, 0.0, 1e-8};
  static constexpr std::array<double, 1> r = {0.01};
  static constexpr double p_of = [] {
    double p = 0.01;
    for (int i = 0; i < Exponent; ++i) p *= 10.0;
    return p;
  }();
  static constexpr std::array<double, 3> p = {p_of, p_of, p_of};
};
template <class RealType, int Exponent>
struct TrackIo : blocks::BlockIo<RealType, TrackConfig<Exponent>> {
  struct Inputs {
    Skipped<V<RealType>> measured;
  };
  struct Outputs {
    V<RealType, 3>& x;
  };
  struct States {
    std::optional<V<RealType, 3>> x{};
  };
};

/// The largest difference of the position in float and double, for p/r = 10^Exponent.
template <int Exponent>
double error_of_track() {
  using Single = TrackIo<float, Exponent>;
  using Double = TrackIo<double, Exponent>;
  KalmanFilter<Single> single;
  KalmanFilter<Double> twice;
  single.reset({});
  twice.reset({});
  double worst = 0.0;
  for (std::uint64_t n = 0; n < 1000; ++n) {
    const auto noise = static_cast<float>(0.1 * std::sin(12.9898 * static_cast<double>(n * n)));
    const V<float> one{{noise}};
    const V<double> two{{static_cast<double>(noise)}};
    V<float, 3> x{};
    V<double, 3> y{};
    typename Single::Outputs out{x};
    typename Double::Outputs right{y};
    single.callback(Tick{n}, {{&one, 1, 1}}, out);
    twice.callback(Tick{n}, {{&two, 1, 1}}, right);
    worst = std::max(worst, std::abs(static_cast<double>(x[0]) - y[0]));
  }
  return worst;
}

TEST(LongRun, KalmanFiltersKeepTheirDigits) {
  EXPECT_LT(error_of_track<0>(), 1e-4);
  EXPECT_LT(error_of_track<3>(), 1e-4);
  EXPECT_LT(error_of_track<6>(), 1e-4);
  EXPECT_LT(error_of_track<9>(), 1e-4);
  EXPECT_LT(error_of_track<11>(), 1e-4);
  EXPECT_LT(error_of_track<12>(), 1e-4);
}

/// The gains kp and ki can be set while it runs.
template <class Real>
struct TunedPidIo : blocks::SetpointPidIo<Real> {
  struct Config : blocks::SetpointPidConfig {
    static constexpr double kp = 1.0;
    static constexpr double ki = 0.0;
    static constexpr double kd = 0.0;
    static constexpr double low = -10.0;
    static constexpr double high = 10.0;
  };
  struct States {
    std::optional<Real> ki{};
  };
};

TEST(PidController, DoesNotJumpWhenItsIntegralIsSwitchedOn) {
  using Io = TunedPidIo<double>;
  PidController<Io> pid;
  pid.reset({});
  V<double> u{};
  Io::Outputs out{u};
  const V<double> measured{{0.9}}, setpoint{{1.0}}, none{{0.0}};
  const auto tick = [&](Seq n) {
    pid.callback({n}, {{&measured, 1, 1}, {&setpoint, 1, 1}, {&none, 1, 1}}, out);
    return u[0];
  };
  for (Seq n = 0; n < 6000; ++n) EXPECT_NEAR(tick(n), 0.1, 1e-12);
  pid.tune({.ki = 1.0});
  EXPECT_NEAR(tick(6000), 0.101, 1e-12);
}

TEST(PidController, StaysWithinItsLimitsAfterHugeMeasurements) {
  using Io = TunedPidIo<float>;
  PidController<Io> pid;
  pid.reset({});
  V<float> u{};
  Io::Outputs out{u};
  const V<float> setpoint{{1.0F}}, none{{0.0F}};
  for (Seq n = 0; n < 80; ++n) {
    const V<float> measured{{n < 10 ? 0.0F : n < 50 ? -3.4e38F : 0.5F}};
    pid.callback({n}, {{&measured, 1, 1}, {&setpoint, 1, 1}, {&none, 1, 1}}, out);
    EXPECT_TRUE(u[0] >= -10.0F && u[0] <= 10.0F) << n << ": " << u[0];
  }
  EXPECT_FLOAT_EQ(u[0], 0.5F);
}

}  // namespace
}  // namespace eagerx::models::testing

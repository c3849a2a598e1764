// Blocks with memory, against scipy and closed forms; a signal that is not finite or not there.
#include <gtest/gtest.h>

#include <cmath>
#include <models/nodes/backlash/backlash.hpp>
#include <models/nodes/complementary_filter/complementary_filter.hpp>
#include <models/nodes/counter/counter.hpp>
#include <models/nodes/derivative/derivative.hpp>
#include <models/nodes/discrete_transfer_function/discrete_transfer_function.hpp>
#include <models/nodes/first_order_lag/first_order_lag.hpp>
#include <models/nodes/integrator/integrator.hpp>
#include <models/nodes/moving_median/moving_median.hpp>
#include <models/nodes/pid_controller/pid_controller.hpp>
#include <models/nodes/state_space/state_space.hpp>
#include <models/nodes/transport_delay/transport_delay.hpp>
#include <models/nodes/unit_delay/unit_delay.hpp>

#include "tests/unit/models/block_harness.hpp"

namespace eagerx::models::testing::blocks {
namespace {

using D1 = V<double>;
using D2 = V<double, 2>;

/// A case of `N` inputs and `M` outputs, in double and float, in two episodes.
template <template <class> class Node, template <class> class Io, std::size_t N, std::size_t M>
void expect_reference(const std::string& name, double in_float, std::size_t column = N) {
  Ticking<Node, Io<double>> node;
  Ticking<Node, Io<float>> small;
  for (int episode = 0; episode < 2; ++episode) {
    for (const auto& row : reference(name)) {
      expect_near<double, M>(node(part<double, N>(row, 0)), row, column, in_float);
      expect_near<float, M>(small(part<float, N>(row, 0)), row, column, in_float);
    }
    node.reset();  // everything is forgotten
    small.reset();
  }
}

TEST(Integrator, IsScipys) {
  expect_reference<Integrator, BackwardIo, 1, 1>("integral", 1e-6, 1);
  expect_reference<Integrator, ForwardIo, 1, 1>("integral", 1e-6, 2);
  expect_reference<Integrator, TrapezoidalIo, 1, 1>("integral", 1e-6, 3);
  expect_lanes<Integrator, BackwardIo, 1>();
  expect_lanes<Integrator, TrapezoidalIo, 1>();
}
TEST(Integrator, LeavesALimitAtOnceAndBeginsWhereAResetSays) {
  Ticking<Integrator, BeginningIo> integrator;
  EXPECT_EQ(integrator(D2{}), (D2{{0.25, 0.5}}));
  for (int i = 0; i < 100; ++i) integrator(D2{{100.0, 100.0}});
  EXPECT_EQ(integrator(D2{{-25.0, kNan<double>}}), (D2{{0.25, 0.5}}));
  EXPECT_EQ(integrator(D2{{kInf, 0.0}}), (D2{{0.25, 0.5}}));
  EXPECT_EQ(integrator.tick({nothing<D2>()}), (D2{{0.25, 0.5}}));
  integrator.reset({V<float, 2>{{-0.5F, -3.0F}}});
  EXPECT_EQ(integrator(D2{}), (D2{{-0.5, -1.0}}));
  integrator.reset();
  EXPECT_EQ(integrator(D2{}), (D2{{0.25, 0.5}})) << "an episode begins at `initial`";
}

TEST(Derivative, IsScipysFilter) {
  expect_reference<Derivative, DerivativeIo, 1, 1>("derivative", 1e-5);
  expect_lanes<Derivative, DerivativeIo, 1>();
  Ticking<Derivative, SignalIo<double, NoFilterConfig>> plain;
  EXPECT_EQ(plain.tick({nothing<D1>()})[0], 0.0);
  EXPECT_EQ(plain(D1{{1.0}})[0], 0.0);
  EXPECT_NEAR(plain(D1{{1.5}})[0], 50.0, 1e-12);
  EXPECT_NEAR(plain(D1{{kNan<double>}})[0], 50.0, 1e-12);
  EXPECT_NEAR(plain(D1{{2.0}})[0], 50.0, 1e-12) << "from the last finite one";
}

TEST(DiscreteTransferFunction, IsScipysLfilter) {
  expect_reference<DiscreteTransferFunction, TransferIo, 1, 1>("transfer", 1e-6);
  expect_lanes<DiscreteTransferFunction, TransferIo, 1>();
  Ticking<DiscreteTransferFunction, TransferIo<double>> held;
  Ticking<DiscreteTransferFunction, TransferIo<double>> wrong;
  EXPECT_EQ(wrong.tick({nothing<D1>()})[0], held(D1{{0.0}})[0]);
  EXPECT_EQ(wrong(D1{{2.0}}), held(D1{{2.0}}));
  EXPECT_EQ(wrong(D1{{kNan<double>}}), held(D1{{2.0}}));
  EXPECT_EQ(wrong(D1{{-kInf}}), held(D1{{2.0}}));
  EXPECT_EQ(wrong(D1{{1.0}}), held(D1{{1.0}}));
}

TEST(StateSpace, IsScipysDlsim) {
  expect_reference<StateSpace, SpaceIo, 2, 2>("space", 1e-6);
  expect_lanes<StateSpace, SpaceIo, 2>();
  Ticking<StateSpace, SpaceIo<double>> held;
  Ticking<StateSpace, SpaceIo<double>> wrong;
  EXPECT_EQ(wrong.tick({nothing<D2>()}), held(D2{}));
  EXPECT_EQ(wrong(D2{{1.0, 2.0}}), held(D2{{1.0, 2.0}}));
  EXPECT_EQ(wrong(D2{{kNan<double>, 3.0}}), held(D2{{1.0, 3.0}}));
}

TEST(FirstOrderLag, IsScipysZeroOrderHold) {
  expect_reference<FirstOrderLag, LagIo, 1, 1>("lag", 1e-6);
  expect_lanes<FirstOrderLag, LagIo, 1>();
  Ticking<FirstOrderLag, SampledLagIo> lag({V<float>{{0.25F}}});
  EXPECT_NEAR(lag(D1{{1.0}})[0], 1.0 - std::exp(-0.04), 1e-12);
  const double y = lag(D1{{1.0}})[0];
  EXPECT_EQ(lag(D1{{kNan<double>}})[0], y);
  EXPECT_EQ(lag.tick({nothing<D1>()})[0], y);
  lag.reset({V<float>{{0.0F}}});
  EXPECT_EQ(lag(D1{{7.3}})[0], 7.3);
}

TEST(Backlash, MovesBehindThePlay) {
  Ticking<Backlash, SampledPlayIo> play;
  for (const auto& [x, y] :
       {std::pair{0.2, 0.0}, {1.0, 0.75}, {0.6, 0.75}, {0.25, 0.5}, {0.3, 0.5}})
    EXPECT_DOUBLE_EQ(play(D1{{x}})[0], y);
  EXPECT_EQ(play(D1{{kNan<double>}})[0], 0.5);
  EXPECT_EQ(play(D1{{kInf}})[0], 0.5);
  EXPECT_EQ(play.tick({nothing<D1>()})[0], 0.5);
  play.reset({V<float>{{2.0F}}});
  EXPECT_EQ(play(D1{{1.5}})[0], 0.5);
  expect_lanes<Backlash, PlayIo, 1>();
}

TEST(TransportDelay, IsNumpysInterp) {
  expect_reference<TransportDelay, DelayIo, 1, 1>("delay", 1e-6);
  expect_lanes<TransportDelay, DelayIo, 1>();
  Ticking<TransportDelay, SampledDelayIo> delay({9.0F});
  for (int n = 0; n < 10; ++n) {
    EXPECT_EQ(delay(D1{{static_cast<double>(n)}})[0], n < 5 ? 0.5 : n - 5.0) << "the longest";
  }
  for (const float none : {0.0F, -1.0F, kNan<float>}) {
    delay.reset({none});
    EXPECT_EQ(delay.tick({nothing<D1>()})[0], 0.5);
    EXPECT_EQ(delay(D1{{3.0}})[0], 3.0);
    EXPECT_TRUE(std::isnan(delay(D1{{kNan<double>}})[0]));
    EXPECT_EQ(delay(D1{{4.0}})[0], 4.0);
  }
}

TEST(UnitDelay, IsTheTickBefore) {
  Ticking<UnitDelay, UnitIo<double>> delay;
  EXPECT_EQ(delay.tick({nothing<D1>()})[0], 0.5);
  EXPECT_EQ(delay(D1{{1.0}})[0], 0.5);
  EXPECT_EQ(delay(D1{{kNan<double>}})[0], 1.0);
  EXPECT_TRUE(std::isnan(delay(D1{{2.0}})[0]));
  expect_lanes<UnitDelay, UnitIo, 1>();
}

TEST(MovingMedian, IsNumpysMedian) {
  expect_reference<MovingMedian, MedianIo, 1, 1>("median", 1e-7);
  expect_lanes<MovingMedian, MedianIo, 1>();
  Ticking<MovingMedian, MedianIo<double>> median;
  EXPECT_EQ(median.tick({nothing<D1>()})[0], 0.0);
  EXPECT_EQ(median(D1{{kNan<double>}})[0], 0.0);
  EXPECT_EQ(median(D1{{3.0}})[0], 3.0);
  EXPECT_EQ(median(D1{{kInf}})[0], kInf);
  EXPECT_EQ(median(D1{{4.0}})[0], 4.0);
}

TEST(Counter, CountsEdgesThatRise) {
  Ticking<Counter, CounterIo<double>> counter;
  EXPECT_EQ(counter.tick({nothing<D1>()})[0], 0.0);
  for (const auto& [x, y] : {std::pair{0.5, 1.0},
                             {0.9, 1.0},
                             {0.0, 1.0},
                             {1.0, 2.0},
                             {kNan<double>, 2.0},
                             {1.0, 0.0},
                             {0.4, 0.0},
                             {kInf, 1.0}})
    EXPECT_EQ(counter(D1{{x}})[0], y);
  counter.reset();
  EXPECT_EQ(counter(D1{{0.0}})[0], 0.0);
  expect_lanes<Counter, CounterIo, 1>();
}

TEST(ComplementaryFilter, JoinsMeasurementAndDerivative) {
  Ticking<ComplementaryFilter, ComplementaryIoOf<double, ComplementaryConfig>> filter;
  Ticking<ComplementaryFilter, ComplementaryIoOf<float, ComplementaryConfig>> in_float;
  for (const auto& row : reference("complementary")) {
    expect_near(filter(part<double, 1>(row, 0), part<double, 1>(row, 1)), row, 2, 0.0);
    expect_near(in_float(part<float, 1>(row, 0), part<float, 1>(row, 1)), row, 2, 1e-6);
  }
  const double y = filter.tick({nothing<D1>(), nothing<D1>()})[0];
  EXPECT_DOUBLE_EQ(filter(D1{{kNan<double>}}, D1{{10.0}})[0], y + 0.1);
  EXPECT_DOUBLE_EQ(filter(D1{{kNan<double>}}, D1{{kNan<double>}})[0], y + 0.1);
  Ticking<ComplementaryFilter, TurningIo<double>> turning;
  EXPECT_EQ(turning(D1{{0.9}}, D1{})[0], 0.9);
  EXPECT_NEAR(turning(D1{{-0.9}}, D1{})[0], 0.95, 1e-12) << "over the end of a turn";
  expect_lanes<ComplementaryFilter, TurningIo, 1, 1>();
}

TEST(PidController, TakesSetpointAndFeedForwardAsSignals) {
  const auto rows = reference("pid");
  const auto run = [&]<class Real>(Real) {
    PidController<SetpointPidIo<Real>> pid;
    pid.reset({});
    const auto next = [&](const auto& measured, const auto& setpoint, const auto& forward) {
      V<Real> u{};
      typename SetpointPidIo<Real>::Outputs out{u};
      pid.callback({0}, {measured, setpoint, forward}, out);
      return u;
    };
    for (const auto& row : rows) {
      const auto measured = part<Real, 1>(row, 0);
      const auto setpoint = part<Real, 1>(row, 1);
      const auto forward = part<Real, 1>(row, 2);
      expect_near(next(window(measured), window(setpoint), window(forward)), row, 3, 1e-5);
    }
    pid.reset({});
    const V<Real> zero{};
    const V<Real> one{{Real(1)}};
    const V<Real> bad{{kNan<Real>}};
    const auto none = nothing<V<Real>>();
    EXPECT_EQ(next(none, window(one), window(one))[0], Real(0));
    EXPECT_EQ(next(window(zero), window(bad), window(one))[0], Real(0));
    EXPECT_EQ(next(window(zero), window(one), window(bad))[0], Real(0));
    EXPECT_EQ(next(window(bad), window(one), window(one))[0], Real(0));
    const Real expected = Real(2) * Real(0.25) + Real(4) * (Real(0.25) * Real(0.01));
    EXPECT_EQ(next(window(zero), none, none)[0], expected)
        << "the parameter until a setpoint comes";
  };
  run(1.0);
  run(1.0F);
}
TEST(PidController, LanesAreThoseOfPlainNumbers) {
  using P = Simd<float, 4>;
  PidController<TightPidIo<P>> vectorized;
  std::array<PidController<TightPidIo<float>>, 4> plain;
  vectorized.reset({});
  for (auto& each : plain) each.reset({});
  Random random({3, 0, 0}, 5);
  for (int t = 0; t < 200; ++t) {
    std::array<V<P>, 3> in;
    for (auto& x : in) {
      for (int k = 0; k < 4; ++k)
        set_lane(x[0], k, random.below(9) == 0 ? kNan<float> : random.uniform(-2.0F, 2.0F));
    }
    V<P> u{};
    TightPidIo<P>::Outputs out{u};
    vectorized.callback({0}, {window(in[0]), window(in[1]), window(in[2])}, out);
    for (int k = 0; k < 4; ++k) {
      std::array<V<float>, 3> one;
      for (std::size_t i = 0; i < 3; ++i) one[i][0] = lane(in[i][0], k);
      V<float> expected{};
      TightPidIo<float>::Outputs result{expected};
      plain[static_cast<std::size_t>(k)].callback(
          {0}, {window(one[0]), window(one[1]), window(one[2])}, result);
      ASSERT_EQ(bits(lane(u[0], k)), bits(expected[0])) << t;
    }
  }
}

}  // namespace
}  // namespace eagerx::models::testing::blocks

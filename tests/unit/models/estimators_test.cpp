// StateFeedback, Observer, KalmanFilter and SensorModel.
#include <gtest/gtest.h>

#include <cmath>
#include <models/nodes/kalman_filter/kalman_filter.hpp>
#include <models/nodes/observer/observer.hpp>
#include <models/nodes/sensor_model/sensor_model.hpp>
#include <models/nodes/state_feedback/state_feedback.hpp>

#include "tests/unit/models/block_harness.hpp"

namespace eagerx::models::testing::blocks {
namespace {

using D1 = V<double>;
using D2 = V<double, 2>;

template <class Real>
V<Real, 2> feedback(Skipped<V<Real, 2>> x, Skipped<V<Real>> reference) {
  StateFeedback<FeedbackIo<Real>> node;
  node.reset({});
  V<Real, 2> u{};
  typename FeedbackIo<Real>::Outputs out{u};
  node.callback({0}, {x, reference}, out);
  return u;
}
TEST(StateFeedback, IsGainTimesState) {
  const D2 x{{0.5, 0.25}};
  const D1 r{{1.0}};
  // 3 − (1 − 0.25), −2 − (0.25 + 1)
  EXPECT_EQ(feedback(window(x), window(r)), (D2{{2.25, -3.25}}));
  const D2 far{{-9.0, 0.0}};
  EXPECT_EQ(feedback(window(far), window(r)), (D2{{5.0, 1.0}}));
  const D2 bad{{0.0, kNan<double>}};
  const D1 infinite{{kInf}};
  EXPECT_EQ(feedback(window(bad), window(r)), D2{});
  EXPECT_EQ(feedback(window(x), window(infinite)), D2{});
  EXPECT_EQ(feedback(window(x), nothing<D1>()), D2{});
  EXPECT_EQ(feedback(nothing<D2>(), window(r)), D2{});
}
TEST(StateFeedback, ChoosesInEachLane) {
  using P = Simd<float, 4>;
  V<P, 2> x{{P(0.5F), P(0.25F)}};
  set_lane(x[0], 2, kNan<float>);
  const V<P> r{{P(1.0F)}};
  const auto u = feedback(window(x), window(r));
  EXPECT_EQ(lane(u[0], 1), 2.25F);
  EXPECT_EQ(lane(u[0], 2), 0.0F);
  EXPECT_EQ(lane(u[1], 2), 0.0F);
  EXPECT_EQ(lane(u[1], 3), -3.25F);
}

/// Ticking, for a node whose output is x.
template <template <class> class Node, class Io>
struct Estimator {
  using Real = typename Io::Real;
  Node<Io> node{};
  Seq n = 0;
  Estimator() { node.reset({}); }
  V<Real, 3> tick(Skipped<V<Real, 2>> measured, Skipped<V<Real, 2>> u) {
    V<Real, 3> x{};
    typename Io::Outputs out{x};
    node.callback({n++}, {measured, u}, out);
    return x;
  }
};
template <template <class> class Node, class Real>
void expect_estimates(const std::string& name, double in_float) {
  Estimator<Node, SystemIo<Real>> node;
  for (int episode = 0; episode < 2; ++episode) {
    for (const auto& row : reference(name)) {
      const auto measured = part<Real, 2>(row, 0);
      const auto u = part<Real, 2>(row, 2);
      expect_near(node.tick(window(measured), window(u)), row, 4, in_float);
    }
    node.node.reset({});
    node.n = 0;
  }
}
template <template <class> class Node>
void expect_predicts_without_measurement() {
  Estimator<Node, SystemIo<double>> node;
  const D2 bad{{kNan<double>, kInf}};
  const V<double, 3> initial{{0.5, -1.0, 0.25}};
  EXPECT_EQ(node.tick(window(bad), window(bad)), initial);
  const auto x = node.tick(nothing<D2>(), nothing<D2>());
  EXPECT_NEAR(x[0], 0.45 - 0.2, 1e-12);
  EXPECT_NEAR(x[1], -0.05 - 0.8 + 0.0125, 1e-12);
  EXPECT_NEAR(x[2], 0.15 + 0.175, 1e-12);
  node.node.reset({V<double, 3>{{7.0, 8.0, 9.0}}});
  node.n = 0;
  EXPECT_EQ(node.tick(nothing<D2>(), nothing<D2>()), (V<double, 3>{{7.0, 8.0, 9.0}}));
}
template <template <class> class Node>
void expect_lanes_of_estimator() {
  using P = Simd<float, 4>;
  Estimator<Node, SystemIo<P>> vectorized;
  std::array<Estimator<Node, SystemIo<float>>, 4> plain;
  Random random({3, 0, 0}, 5);
  for (int t = 0; t < 60; ++t) {
    std::array<V<P, 2>, 2> in;
    for (auto& x : in) {
      for (auto& element : x) {
        for (int k = 0; k < 4; ++k)
          set_lane(element, k, random.below(9) == 0 ? kNan<float> : random.uniform(-2.0F, 2.0F));
      }
    }
    const auto x = vectorized.tick(window(in[0]), window(in[1]));
    for (int k = 0; k < 4; ++k) {
      const V<float, 2> measured{{lane(in[0][0], k), lane(in[0][1], k)}};
      const V<float, 2> u{{lane(in[1][0], k), lane(in[1][1], k)}};
      const auto expected = plain[static_cast<std::size_t>(k)].tick(window(measured), window(u));
      for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(bits(lane(x[i], k)), bits(expected[i])) << t;
    }
  }
}
TEST(Observer, IsTheRecursionOfItsErrors) {
  expect_estimates<Observer, double>("observer", 0.0);
  expect_estimates<Observer, float>("observer", 1e-6);
  expect_predicts_without_measurement<Observer>();
  expect_lanes_of_estimator<Observer>();
}
TEST(KalmanFilter, IsJosephsFormWithAnInverse) {
  expect_estimates<KalmanFilter, double>("kalman", 0.0);
  expect_estimates<KalmanFilter, float>("kalman", 1e-5);
  expect_predicts_without_measurement<KalmanFilter>();
  expect_lanes_of_estimator<KalmanFilter>();
}
TEST(KalmanFilter, TakesWholeMatricesToo) {
  Estimator<KalmanFilter, SystemIo<double>> diagonal;
  Estimator<KalmanFilter, WholeMatricesIo> whole;
  for (const auto& row : reference("kalman")) {
    const auto y = part<double, 2>(row, 0);
    EXPECT_EQ(whole.tick(window(y), window(y)), diagonal.tick(window(y), window(y)));
  }
}

TEST(SensorModel, BendsAsItsParametersSay) {
  Ticking<SensorModel, SignalIo<double, IdealConfig, 2>> ideal;
  const D2 x{{1.2345, -7.0}};
  EXPECT_EQ(ideal.tick({nothing<D2>()}), D2{});
  EXPECT_EQ(ideal(x), x);
  EXPECT_TRUE(std::isnan(ideal(D2{{kNan<double>, 0.0}})[0]));
  Ticking<SensorModel, SensorIo<double, BentConfig>> bent;
  EXPECT_EQ(bent(D2{{1.0, 1.0}}), (D2{{2.5, 1.5}}));
  EXPECT_EQ(bent(D2{{1.0, 1.0}}), (D2{{2.5, 1.5}})) << "2.6 and 1.6 in quarters";
  for (int i = 0; i < 8; ++i) bent(x);
  EXPECT_EQ(bent(D2{{1.0, -9.0}}), (D2{{3.5, -3.0}})) << "a drift of 1 after 10 ticks";
  bent.reset({V<float, 2>{{1.0F, 2.0F}}, std::nullopt});
  EXPECT_EQ(bent(D2{{1.0, 1.0}}), (D2{{3.0, 4.0}}));
  bent.reset({});
  EXPECT_EQ(bent(D2{{1.0, 1.0}}), (D2{{3.0, 4.0}})) << "keeps its value";
}
TEST(SensorModel, NoiseHasItsDeviationAndDropOutsTheirProbability) {
  Ticking<SensorModel, NoisyIo<double>> sensor;
  constexpr int kTicks = 20'000;
  double sum = 0.0;
  double squares = 0.0;
  double products = 0.0;
  int held = 0;
  D2 before{{kInf, kInf}};
  for (int n = 0; n < kTicks; ++n) {
    const D2 y = sensor(D2{{3.0, 3.0}});
    held += y[0] == before[0];
    before = y;
    sum += y[0] - 3.0;
    squares += (y[0] - 3.0) * (y[0] - 3.0);
    products += (y[0] - 3.0) * (y[1] - 3.0);
  }
  EXPECT_NEAR(sum / kTicks, 0.0, 0.025);
  EXPECT_NEAR(squares / kTicks, 0.25, 0.015);
  EXPECT_NEAR(products / kTicks, 0.0, 0.015) << "elements are independent";
  EXPECT_NEAR(static_cast<double>(held) / kTicks, 0.25, 0.015);
}
template <class Real>
using EvenIo = SignalIo<Real, EvenConfig, 2>;

TEST(SensorModel, EvenNoiseStaysWithinItsSpread) {
  Ticking<SensorModel, EvenIo<double>> sensor;
  constexpr int kTicks = 20'000;
  double sum = 0.0, squares = 0.0, products = 0.0, most = 0.0;
  for (int n = 0; n < kTicks; ++n) {
    const D2 y = sensor(D2{{3.0, 3.0}});
    ASSERT_LE(std::abs(y[0] - 3.0), 0.5);
    ASSERT_LE(std::abs(y[1] - 3.0), 2.0);
    most = std::max(most, std::abs(y[1] - 3.0));
    sum += y[1] - 3.0;
    squares += (y[1] - 3.0) * (y[1] - 3.0);
    products += (y[0] - 3.0) * (y[1] - 3.0);
  }
  EXPECT_GT(most, 1.99);
  EXPECT_NEAR(sum / kTicks, 0.0, 0.04);
  EXPECT_NEAR(squares / kTicks, 4.0 / 3.0, 0.05);
  EXPECT_NEAR(products / kTicks, 0.0, 0.02) << "elements are independent";
  expect_lanes<SensorModel, EvenIo, 2>();
}
TEST(SensorModel, SeedsDecide) {
  Ticking<SensorModel, SensorIo<float, NoisyConfig>> sensor;
  const auto run = [&](std::optional<std::uint32_t> seed) {
    sensor.reset({std::nullopt, seed});
    std::vector<V<float, 2>> all;
    for (int n = 0; n < 10; ++n) all.push_back(sensor(V<float, 2>{}));
    return all;
  };
  const auto first = run(std::nullopt);
  EXPECT_EQ(run(0), first) << "the parameter is 0";
  const auto other = run(4'000'000'000U);
  EXPECT_NE(other, first);
  EXPECT_EQ(run(std::nullopt), other) << "keeps the seed";
  EXPECT_EQ(run(0), first);
  expect_lanes<SensorModel, NoisyIo, 2>();
}

}  // namespace
}  // namespace eagerx::models::testing::blocks

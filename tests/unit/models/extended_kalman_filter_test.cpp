// ExtendedKalmanFilter, and the derivative of a prediction.
#include <gtest/gtest.h>

#include <cmath>
#include <models/engines/ode_engine/rk4.hpp>
#include <models/nodes/extended_kalman_filter/extended_kalman_filter.hpp>

#include "tests/unit/models/block_harness.hpp"

namespace eagerx::models::testing::blocks {
namespace {

using D1 = V<double>;
using D2 = V<double, 2>;

/// Pendulum without its Jacobian and without coefficients.
template <class RealType>
struct PlainPendulum {
  using Real = RealType;
  using Whole = typename PendulumModelIo<Real>::Model;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 8;
  static auto default_parameters() { return Whole::default_parameters(); }
  static auto derivative(const Array<Real, 8>& p, const Array<Real, 1>& u, Array<Real, 2> x) {
    return Whole::derivative(Whole::precompute(p, u), x);
  }
};
template <class RealType>
struct PlainModelIo {
  using Model = PlainPendulum<RealType>;
};

template <class Io>
struct Filter {
  using Real = typename Io::Real;
  ExtendedKalmanFilter<Io> node{};
  Seq n = 0;
  Filter() { node.reset({}); }
  V<Real, 2> tick(Skipped<V<Real, 2>> measured, Skipped<V<Real>> u) {
    V<Real, 2> x{};
    typename Io::Outputs out{x};
    node.callback({n++}, {measured, u}, out);
    return x;
  }
  std::uint32_t restarts() const {
    std::uint32_t result = 77;
    node.for_each_count([&](const char* /*name*/, std::uint32_t count) { result = count; });
    return result;
  }
};

/// The largest error over the reference, relative to numbers above 1.
template <class Io>
double largest_error() {
  using Real = typename Io::Real;
  Filter<Io> filter;
  double error = 0.0;
  for (int episode = 0; episode < 2; ++episode) {
    for (const auto& row : reference("extended_kalman")) {
      const auto measured = part<Real, 2>(row, 0);
      const auto u = part<Real, 1>(row, 2);
      const auto x = filter.tick(window(measured), window(u));
      for (std::size_t i = 0; i < 2; ++i) {
        const double expected = row.at(3 + i);
        const double scale = std::max(1.0, std::abs(expected));
        error = std::max(error, std::abs(static_cast<double>(x[i]) - expected) / scale);
      }
    }
    filter.node.reset({});
    filter.n = 0;
  }
  EXPECT_EQ(filter.restarts(), 0U);
  return error;
}
TEST(ExtendedKalmanFilter, IsJosephsFormWithComplexDifferences) {
  EXPECT_LT(largest_error<ExtendedIo<double>>(), 1e-12);
  EXPECT_LT(largest_error<ExtendedIo<float>>(), 1e-5);
}
TEST(ExtendedKalmanFilter, NeedsNoJacobian) {
  using Double = ExtendedIo<double, ExtendedConfig<PlainModelIo<double>>>;
  using Float = ExtendedIo<float, ExtendedConfig<PlainModelIo<float>>>;
  EXPECT_LT(largest_error<Double>(), 1e-8);
  EXPECT_LT(largest_error<Float>(), 1e-3);
}

TEST(ExtendedKalmanFilter, PredictsAsTheEngineDoes) {
  using Model = PendulumModelIo<float>::Model;
  const Model::Input u{{1.5F}};
  const OdeJacobian<Model> jacobian(Model::default_parameters(), u);
  Model::State x{{0.7F, -2.0F}};
  auto prediction = OdePrediction<Model>::from(x);
  for (int i = 0; i < 50; ++i) {
    x = rk4_step(OdeDerivative<Model>(Model::default_parameters(), u), x, 0.005F);
    prediction.step(jacobian, 0.005F);
    ASSERT_EQ(prediction.x, x) << i;
  }
}

TEST(ExtendedKalmanFilter, PredictsWithoutMeasurement) {
  using Model = PendulumModelIo<double>::Model;
  Filter<ExtendedIo<double>> filter;
  const D2 bad{{kNan<double>, kInf}};
  const D1 bad_input{{kInf}};
  Model::State x{{0.5, -1.0}};
  EXPECT_EQ(filter.tick(window(bad), window(bad_input)), x);
  const OdeDerivative<Model> unforced(Model::default_parameters(), {{0.0}});
  for (int n = 0; n < 3; ++n) {
    for (int i = 0; i < 4; ++i) x = rk4_step(unforced, x, 0.0025);
    EXPECT_EQ(filter.tick(nothing<D2>(), n == 0 ? nothing<D1>() : window(bad_input)), x);
  }
  filter.node.reset({D2{{7.0, 8.0}}});
  filter.n = 0;
  EXPECT_EQ(filter.tick(nothing<D2>(), nothing<D1>()), (D2{{7.0, 8.0}}));
}

struct TurningFilterConfig : ExtendedConfig<PendulumModelIo<double>> {
  static constexpr std::array<double, 2> turn = {2.0, 0.0};
};
TEST(ExtendedKalmanFilter, TakesTheShortWayRound) {
  Filter<ExtendedIo<double>> plain;
  Filter<ExtendedIo<double, TurningFilterConfig>> turning;
  const D2 near{{0.75, -1.0}};
  const D2 three_turns_on{{6.75, -1.0}};
  EXPECT_EQ(turning.tick(window(three_turns_on), nothing<D1>()),
            plain.tick(window(near), nothing<D1>()));
}

struct LightPendulumConfig : ExtendedConfig<PendulumModelIo<double>> {
  static constexpr std::array<double, 8> parameters = {1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
};
TEST(ExtendedKalmanFilter, TakesParameters) {
  Filter<ExtendedIo<double, LightPendulumConfig>> filter;
  filter.tick(nothing<D2>(), nothing<D1>());
  const D1 volts{{2.0}};
  EXPECT_NEAR(filter.tick(nothing<D2>(), window(volts))[0], 0.49, 1e-15) << "without any force";
}

TEST(ExtendedKalmanFilter, BeginsAnewAfterNumbersThatAreNotFinite) {
  Filter<ExtendedIo<float>> filter;
  filter.node.reset({V<float, 2>{{0.0F, 3e38F}}});
  const V<float> none{};
  const V<float, 2> bad{{kNan<float>, kNan<float>}};
  filter.tick(window(bad), window(none));
  EXPECT_EQ(filter.tick(window(bad), window(none)), (V<float, 2>{{0.5F, -1.0F}}));
  EXPECT_EQ(filter.restarts(), 1U);
  const V<float, 2> good{{0.6F, 0.0F}};
  const auto x = filter.tick(window(good), window(none));
  EXPECT_NEAR(x[0], 0.6F, 0.05F);
  EXPECT_EQ(filter.restarts(), 1U);
}

}  // namespace
}  // namespace eagerx::models::testing::blocks

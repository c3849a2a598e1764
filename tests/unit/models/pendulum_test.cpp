#include <gtest/gtest.h>

#include <cmath>
#include <models/objects/test_pendulum/test_pendulum_ode.hpp>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {
namespace {

using OdeModel = PendulumOde<PendulumModelIo<double>>;

/// dω/dt as it is written in EAGERx's tutorials, with the overflow-safe form of the sigmoid.
double acceleration(double theta, double omega, double u) {
  const auto p = OdeModel::default_parameters();
  const double z = p[7] * omega;
  const double sigmoid = z < 0.0 ? std::exp(z) / (1.0 + std::exp(z)) : 1.0 / (1.0 + std::exp(-z));
  return (p[4] / p[5] * u + p[1] * 9.81 * p[2] * std::sin(theta) - p[3] * omega -
          p[4] * p[4] / p[5] * omega - p[6] * (2.0 * sigmoid - 1.0)) /
         p[0];
}

TEST(PendulumOde, DerivativeIsThatOfTheTutorials) {
  for (double theta = -4.0; theta <= 4.0; theta += 0.37) {
    for (const double omega : {-30.0, -1.0, -0.01, 0.0, 0.003, 0.2, 9.0}) {
      for (const double u : {-2.0, 0.0, 1.3}) {
        const auto c = OdeModel::precompute(OdeModel::default_parameters(), {{u}});
        const auto slope = OdeModel::derivative(c, {{theta, omega}});
        const double expected = acceleration(theta, omega, u);
        EXPECT_EQ(slope[0], omega);
        EXPECT_NEAR(slope[1], expected, 1e-12 * (200.0 + std::abs(expected)));
      }
    }
  }
}

TEST(PendulumOde, JacobianIsThatOfFiniteDifferences) {
  const auto c = OdeModel::precompute(OdeModel::default_parameters(), {{1.3}});
  constexpr double kStep = 1e-6;
  for (const double theta : {-3.0, -0.4, 0.0, 1.1, 2.9}) {
    for (const double omega : {-5.0, -0.02, 0.0, 0.004, 0.5}) {
      const auto jacobian = OdeModel::jacobian(c, {{theta, omega}});
      for (std::size_t column = 0; column < 2; ++column) {
        Array<double, 2> above{{theta, omega}};
        Array<double, 2> below = above;
        above[column] += kStep;
        below[column] -= kStep;
        for (std::size_t row = 0; row < 2; ++row) {
          const double slope =
              (OdeModel::derivative(c, above)[row] - OdeModel::derivative(c, below)[row]) /
              (2.0 * kStep);
          EXPECT_NEAR(jacobian[row * 2 + column], slope, 1e-5 * (1.0 + std::abs(slope)));
        }
      }
    }
  }
}

TEST(PendulumOde, FrictionIsFiniteAtAnySpeed) {
  using FloatModel = PendulumOde<PendulumModelIo<float>>;
  const auto c = FloatModel::precompute(FloatModel::default_parameters(), {{0.0F}});
  for (const float omega : {-1e20F, -1e3F, 1e3F, 1e20F}) {
    EXPECT_TRUE(std::isfinite(FloatModel::derivative(c, {{0.0F, omega}})[1]));
    EXPECT_TRUE(std::isfinite(FloatModel::jacobian(c, {{0.0F, omega}})[3]));
  }
}

TEST(PendulumOde, HangsStillAndFallsFromUpright) {
  const auto c = OdeModel::precompute(OdeModel::default_parameters(), {{0.0}});
  EXPECT_NEAR(OdeModel::derivative(c, {{3.14159265358979, 0.0}})[1], 0.0, 1e-10);
  EXPECT_GT(OdeModel::derivative(c, {{0.1, 0.0}})[1], 0.0);
  EXPECT_LT(OdeModel::derivative(c, {{-0.1, 0.0}})[1], 0.0);
}

TEST(TestPendulumOde, DerivativeAndJacobianAreThoseOfEagerxsTests) {
  using TestModel = TestPendulumOde<PendulumModelIo<double>>;
  const auto p = TestModel::default_parameters();
  for (const double theta : {-3.0, 0.2, 2.0}) {
    for (const double omega : {-6.0, 0.0, 1.5}) {
      const double u = 1.7;
      const double expected = (p[1] * 9.81 * p[2] * std::sin(theta) -
                               (p[3] + p[4] * p[4] / p[5]) * omega + p[4] * u / p[5]) /
                              p[0];
      const auto c = TestModel::precompute(p, {{u}});
      const auto slope = TestModel::derivative(c, {{theta, omega}});
      EXPECT_EQ(slope[0], omega);
      EXPECT_NEAR(slope[1], expected, 1e-12 * (200.0 + std::abs(expected)));
      const auto jacobian = TestModel::jacobian(c, {{theta, omega}});
      EXPECT_EQ(jacobian[1], 1.0);
      EXPECT_NEAR(jacobian[2], p[1] * 9.81 * p[2] * std::cos(theta) / p[0], 1e-10);
      EXPECT_NEAR(jacobian[3], -(p[3] + p[4] * p[4] / p[5]) / p[0], 1e-12);
    }
  }
}

}  // namespace
}  // namespace eagerx::models::testing

// Derivatives by dual numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <eagerx/math.hpp>
#include <eagerx/simd.hpp>
#include <numbers>

namespace eagerx {
namespace {

using D = Dual<double, 2>;

/// f over a dual number against the function itself: the same bits of the value, and the
/// derivative of central differences.
template <class F>
void expect_derivative(const char* name, F f, std::initializer_list<double> points) {
  for (const double x : points) {
    const D at = f(D::variable(x, 1));
    EXPECT_EQ(at.value, f(x)) << name << " " << x;
    constexpr double kStep = 1e-6;
    const double slope = (f(x + kStep) - f(x - kStep)) / (2.0 * kStep);
    EXPECT_NEAR(at.derivative[1], slope, 1e-7 * (1.0 + std::abs(slope))) << name << " " << x;
    EXPECT_EQ(at.derivative[0], 0.0) << name << " " << x;
  }
}

#define EXPECT_DERIVATIVE(expression, ...) \
  expect_derivative(#expression, [](auto x) { return expression; }, {__VA_ARGS__})

TEST(Dual, FunctionsHaveTheirDerivatives) {
  EXPECT_DERIVATIVE(-x + x * x * 3.0 - x / (x * x + 2.0), -2.0, 0.5);
  EXPECT_DERIVATIVE((x += 1.5, x -= x * x, x *= x, x /= 3.0, x), -2.0, 0.7);
  EXPECT_DERIVATIVE(eagerx::abs(x), -2.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::square(x) + eagerx::cube(x), -2.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::copysign(x * x, x - 1.0), -2.0, 0.5, 1.5);
  EXPECT_DERIVATIVE(eagerx::min(x, x * x) + eagerx::max(x, 1.0 - x), -2.0, 0.3, 1.5);
  EXPECT_DERIVATIVE(eagerx::clamp(x * 2.0, -1.0, 1.0), -2.0, 0.3, 1.5);
  EXPECT_DERIVATIVE(eagerx::sqrt(x), 0.01, 2.0);
  EXPECT_DERIVATIVE(eagerx::exp(x), -2.0, 0.5, 3.0);
  EXPECT_DERIVATIVE(eagerx::log(x), 0.1, 5.0);
  EXPECT_DERIVATIVE(eagerx::log10(x), 0.1, 5.0);
  EXPECT_DERIVATIVE(eagerx::sin(x), -2.0, 0.5, 30.0);
  EXPECT_DERIVATIVE(eagerx::cos(x), -2.0, 0.5, 30.0);
  EXPECT_DERIVATIVE(eagerx::tan(x), -1.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::asin(x), -0.9, 0.5);
  EXPECT_DERIVATIVE(eagerx::acos(x), -0.9, 0.5);
  EXPECT_DERIVATIVE(eagerx::atan(x), -2.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::sinh(x), -2.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::cosh(x), -2.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::tanh(x), -2.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::sigmoid(x), -2.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::atan2(x * x, x - 1.0), -2.0, 0.5, 1.7);
  EXPECT_DERIVATIVE(eagerx::pow(x, x * 0.5), 0.3, 2.0);
  EXPECT_DERIVATIVE(eagerx::pow(x, 3.0), -2.0, 0.5);
  EXPECT_DERIVATIVE(eagerx::fmod(x * x, x), 1.3, 2.6);
  EXPECT_DERIVATIVE(eagerx::trunc(x) + eagerx::floor(x) + eagerx::ceil(x) + eagerx::round(x), -2.3,
                    0.7);
  EXPECT_DERIVATIVE(select(x < 0.0, x * x, 3.0 * x), -2.0, 0.5);
}

TEST(Dual, KeepsSeveralVariablesApart) {
  const D x = D::variable(3.0, 0);
  const D y = D::variable(2.0, 1);
  const D product = x * eagerx::pow(y, x) + std::numbers::pi_v<D>;
  EXPECT_DOUBLE_EQ(product.value, 24.0 + std::numbers::pi);
  EXPECT_DOUBLE_EQ(product.derivative[0], 8.0 + 24.0 * std::log(2.0));
  EXPECT_DOUBLE_EQ(product.derivative[1], 3.0 * 3.0 * 4.0);
}

TEST(Dual, ConstantsStayConstantWhereASlopeIsInfinite) {
  EXPECT_EQ(eagerx::sqrt(D(0.0)).derivative[0], 0.0);
  EXPECT_EQ(eagerx::pow(D(0.0), D(0.5)).derivative[1], 0.0);
  EXPECT_EQ(eagerx::pow(D::variable(-2.0, 0), D(2.0)).derivative[0], -4.0);
  EXPECT_TRUE(eagerx::isnan(D(std::nan(""))));
  EXPECT_TRUE(eagerx::isfinite(D(1.0)));
}

TEST(Dual, OfSimdHasTheBitsOfEachLane) {
  using P = Simd<float, 4>;
  const auto f = [](auto x) { return eagerx::tanh(x * x) + eagerx::sin(x) / eagerx::sqrt(x); };
  P x(0.0F);
  for (int i = 0; i < 4; ++i) set_lane(x, i, 0.3F + static_cast<float>(i));
  const auto all = f(Dual<P, 1>::variable(x, 0));
  for (int i = 0; i < 4; ++i) {
    const auto one = f(Dual<float, 1>::variable(lane(x, i), 0));
    EXPECT_EQ(lane(all.value, i), one.value) << i;
    EXPECT_EQ(lane(all.derivative[0], i), one.derivative[0]) << i;
  }
}

}  // namespace
}  // namespace eagerx

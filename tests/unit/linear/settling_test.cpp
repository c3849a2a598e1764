// Numbers that depend on nothing but themselves: which ones, and where they come to rest.
#include <gtest/gtest.h>

#include <cmath>
#include <targets/linearize/settling.hpp>

namespace eagerx::linearize {
namespace {

using Numbers = Settling::Numbers;
using Slopes = std::vector<Numbers>;

/// The variance p of a Kalman filter after a measurement: m = p + q, p' = m·r/(m + r).
TEST(Settling, ReachesTheSteadyVarianceOfASlowFilter) {
  constexpr double kQ = 1e-8, kR = 1.0;  // 10000 steps of the iteration alone
  const auto next = [](const Numbers& p) -> Numbers {
    const double m = p[0] + kQ;
    return {m * kR / (m + kR)};
  };
  const auto slopes = [](const Numbers& p) -> Slopes {
    const double m = p[0] + kQ;
    return {{std::pow(kR / (m + kR), 2.0)}};
  };
  Numbers p = {1.0};
  ASSERT_TRUE(Settling(next, slopes).run(p));
  const double m = (kQ + std::sqrt(kQ * kQ + 4.0 * kQ * kR)) / 2.0, wanted = m * kR / (m + kR);
  EXPECT_NEAR(p[0] / wanted, 1.0, 1e-10);
}

TEST(Settling, SolvesCoupledNumbersOfDifferentSizes) {
  const Slopes a = {{0.5, 1e6}, {0.0, 0.999999}};
  const Numbers b = {1.0, 1e-9};
  const auto next = [&](const Numbers& x) -> Numbers {
    return {a[0][0] * x[0] + a[0][1] * x[1] + b[0], a[1][1] * x[1] + b[1]};
  };
  Numbers x = {0.0, 0.0};
  ASSERT_TRUE(Settling(next, [&](const Numbers&) { return a; }).run(x));
  EXPECT_NEAR(x[1], 1e-3, 1e-11);
  EXPECT_NEAR(x[0], 2002.0, 1e-4);
}

TEST(Settling, RefusesWhatCirclesOrDiverges) {
  const double c = std::cos(0.1), s = std::sin(0.1);
  const auto turn = [&](const Numbers& x) -> Numbers {
    return {c * x[0] - s * x[1], s * x[0] + c * x[1]};
  };
  const auto no_slopes = [](const Numbers& x) { return Slopes(x.size(), Numbers(x.size())); };
  Numbers x = {1.0, 0.0};
  EXPECT_FALSE(Settling(turn, no_slopes).run(x));
  const auto grow = [](const Numbers& y) -> Numbers { return {y[0] * y[0] * 10.0}; };
  Numbers y = {1.0};
  EXPECT_FALSE(Settling(grow, no_slopes).run(y));
}

/// 0 and 1 of a node: 1 drives 0. 2 of a node is driven by 3 of another one. 4 is a parameter, that
/// 1 depends on; 5 is a clock, that 6 depends on. 7 depends on an input, 8 is of no node.
TEST(Settling, ChoosesNumbersThatDependOnNothingElse) {
  Slopes a(9, Numbers(9));
  a[0][0] = a[0][1] = a[1][1] = 0.5;
  a[2][2] = a[2][3] = a[3][3] = 0.5;
  a[1][4] = a[4][4] = a[5][5] = 1.0;
  a[6][6] = a[6][5] = a[7][7] = a[8][8] = 0.5;
  const std::vector<std::ptrdiff_t> nodes = {0, 0, 1, 2, 3, 4, 4, 5, -1};
  std::vector<bool> moves(9, true), independent(9, true);
  moves[4] = false;
  independent[7] = false;
  const std::vector<std::vector<std::size_t>> wanted = {{0, 1}, {3}};
  EXPECT_EQ(independent_numbers(a, nodes, moves, independent), wanted);
  moves[3] = false;  // at rest already
  EXPECT_EQ(independent_numbers(a, nodes, moves, independent).size(), 1U);
}

}  // namespace
}  // namespace eagerx::linearize

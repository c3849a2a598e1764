// Gains of regulators and filters against closed forms, relative to 1e-9.
#include "generator/tools/linear/riccati.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "generator/tools/linear/design.hpp"
#include "generator/tools/linear/hidden_modes.hpp"
#include "generator/tools/linear/periodic.hpp"
#include "generator/tools/linear/stabilize.hpp"

namespace eagerx::gen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double kTolerance = 1e-9;

/// The regulator of x' = a·x + b·u with the cost q·x² + r·u²: b²p² + p(r - a²r - b²q) - qr = 0.
double scalar_gain(double a, double b, double q, double r) {
  const double half = (b * b * q + a * a * r - r) / 2.0;
  // The root that does not cancel.
  const double root = std::sqrt(half * half + b * b * q * r);
  const double p = half > 0.0 ? (half + root) / (b * b) : q * r / (root - half);
  return a * b * p / (r + b * b * p);
}

MatrixXd one(double x) {
  return MatrixXd::Constant(1, 1, x);
}
LinearQuadratic scalar(double a, double b, double q, double r) {
  return {one(a), one(b), one(q), one(r), one(0.0)};
}

void expect_near(const MatrixXd& found, const MatrixXd& wanted) {
  ASSERT_EQ(found.rows(), wanted.rows());
  ASSERT_EQ(found.cols(), wanted.cols());
  for (Index i = 0; i < wanted.rows(); ++i) {
    const double scale = wanted.row(i).cwiseAbs().maxCoeff();
    for (Index k = 0; k < wanted.cols(); ++k)
      EXPECT_NEAR(found(i, k), wanted(i, k), kTolerance * scale) << i << ", " << k;
  }
}
void expect_gain(const LinearQuadratic& problem, const MatrixXd& wanted) {
  const auto found = solve_riccati(problem);
  ASSERT_TRUE(found);
  EXPECT_LT(found->spectral_radius, 1.0);
  expect_near(found->gain, wanted);
}

/// An orthogonal matrix that mixes all states: I - 2·v·v'/(v'v).
MatrixXd reflection(Index n) {
  VectorXd v(n);
  for (Index i = 0; i < n; ++i) v[i] = 1.0 + 0.37 * static_cast<double>(i % 5);
  return MatrixXd::Identity(n, n) - 2.0 * v * v.transpose() / v.squaredNorm();
}

/// Scalar plants, seen in states that mix them.
void expect_mixed(const VectorXd& a, const VectorXd& b, const VectorXd& q, const VectorXd& r) {
  const Index n = a.size();
  const MatrixXd t = reflection(n);
  MatrixXd gain = MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i) gain(i, i) = scalar_gain(a[i], b[i], q[i], r[i]);
  expect_gain({t * a.asDiagonal() * t.transpose(), t * MatrixXd(b.asDiagonal()),
               t * q.asDiagonal() * t.transpose(), MatrixXd(r.asDiagonal()), MatrixXd::Zero(n, n)},
              gain * t.transpose());
}

/// The same with a delay of the input: u = -k·(x when u acts).
void expect_delayed(double a, double b, double q, double r, Index delay) {
  const Index n = delay + 1;
  LinearQuadratic problem{MatrixXd::Zero(n, n), MatrixXd::Zero(n, 1), MatrixXd::Zero(n, n), one(r),
                          MatrixXd::Zero(n, 1)};
  problem.a(0, 0) = a;
  problem.a(0, 1) = b;
  for (Index i = 1; i < delay; ++i) problem.a(i, i + 1) = 1.0;
  problem.b(delay, 0) = 1.0;
  problem.q(0, 0) = q;
  MatrixXd wanted(1, n);
  wanted(0, 0) = std::pow(a, static_cast<double>(delay));
  for (Index i = 1; i <= delay; ++i) wanted(0, i) = std::pow(a, static_cast<double>(delay - i)) * b;
  expect_gain(problem, scalar_gain(a, b, q, r) * wanted);
}

TEST(Riccati, Unstable) {
  expect_gain(scalar(1.2, 0.5, 2.0, 3.0), one(scalar_gain(1.2, 0.5, 2.0, 3.0)));
}
TEST(Riccati, StronglyUnstableAndNearlyFree) {
  expect_gain(scalar(30.0, 1e-3, 1e-8, 1.0), one(scalar_gain(30.0, 1e-3, 1e-8, 1.0)));
}
TEST(Riccati, IntegratorThatHardlyCosts) {
  expect_gain(scalar(1.0, 1e-4, 1e-6, 1.0), one(scalar_gain(1.0, 1e-4, 1e-6, 1.0)));
}
TEST(Riccati, TheCostOfBothAtOnce) {
  // With v = u + s/r·x there is no S.
  const double a = 1.1, b = 0.4, q = 2.0, r = 0.7, s = 0.3;
  LinearQuadratic problem = scalar(a, b, q, r);
  problem.s = one(s);
  expect_gain(problem, one(scalar_gain(a - b * s / r, b, q - s * s / r, r) + s / r));
}
TEST(Riccati, DelayOfFive) {
  expect_delayed(0.9, 0.5, 1.0, 0.1, 5);
}
TEST(Riccati, UnstableWithDelayOfTen) {
  expect_delayed(1.15, 0.2, 3.0, 1.0, 10);
}
TEST(Riccati, Stiff) {
  VectorXd a(4), b(4), q(4), r(4);
  a << 1.0 - 1e-7, 0.5, 1e-2, 1.3;
  b << 1e-3, 1.0, 1.0, 0.1;
  q << 1.0, 10.0, 1.0, 1.0;
  r << 1.0, 1.0, 1.0, 1.0;
  expect_mixed(a, b, q, r);
}
TEST(Riccati, TwelveStates) {
  VectorXd a(12), b(12), q(12), r(12);
  for (Index i = 0; i < 12; ++i) {
    const auto at = static_cast<double>(i);
    a[i] = 0.1 * at + 0.05;  // 1.15 is the largest
    b[i] = 1.0 / (1.0 + at);
    q[i] = 1.0 + at * at;
    r[i] = 0.5 + 0.1 * at;
  }
  expect_mixed(a, b, q, r);
}

/// Position and speed with white acceleration: Kalata, The tracking index, IEEE Trans. Aerospace
/// and Electronic Systems 20 (1984), 174-182.
void expect_tracker(double period, double acceleration, double noise) {
  const double index = acceleration * period * period / noise;
  // (4 + λ - √(8λ + λ²))/4 is 1 - this.
  const double less = (std::sqrt(8.0 * index + index * index) - index) / 4.0;
  const double alpha = less * (2.0 - less);
  const double beta = 2.0 * less * less;  // 2·(2 - α) - 4·√(1 - α)
  KalmanRequest request;
  request.model = {2, {1.0, period, 0.0, 1.0}, {period * period / 2.0, period}, {1.0, 0.0}};
  request.process = {0.0, 0.0};
  request.input = {acceleration};
  request.measured = {noise};
  const KalmanDesign found = design_kalman(request);
  ASSERT_EQ(found.problem, "");
  ASSERT_EQ(found.gain.size(), 2U);
  EXPECT_NEAR(found.gain[0], alpha, kTolerance * alpha);
  EXPECT_NEAR(found.gain[1], beta / period, kTolerance * beta / period);
  EXPECT_EQ(found.q.size(), 4U) << "the noises of both states are the same";
}
TEST(Riccati, TrackerOfFastMoves) {
  expect_tracker(0.1, 20.0, 0.05);
}
TEST(Riccati, TrackerOfSlowMoves) {
  expect_tracker(0.005, 1.0, 0.01);
}
TEST(Riccati, RandomWalk) {
  KalmanRequest request;
  request.model = {1, {1.0}, {0.0}, {1.0}};
  request.process = {0.01};
  request.measured = {0.5};
  const KalmanDesign found = design_kalman(request);
  const double q = 1e-4, r = 0.25, p = (q + std::sqrt(q * q + 4.0 * q * r)) / 2.0;
  ASSERT_EQ(found.gain.size(), 1U);
  EXPECT_NEAR(found.gain[0], p / (p + r), kTolerance * found.gain[0]);
  EXPECT_NEAR(found.deviations[0], std::sqrt(p * r / (p + r)), kTolerance);
  EXPECT_NEAR(found.spectral_radius, 1.0 - found.gain[0], kTolerance);
  EXPECT_EQ(found.q, std::vector<double>({0.01 * 0.01}));
}

TEST(Riccati, RefusesWhatNoInputMoves) {
  EXPECT_FALSE(solve_riccati(scalar(1.2, 0.0, 1.0, 1.0)));
}
TEST(Riccati, RefusesAnUnstableModeThatCostsNothing) {
  EXPECT_FALSE(solve_riccati(scalar(1.2, 1.0, 0.0, 1.0)));
}
TEST(Riccati, NamesTheStateThatIsNotMeasured) {
  KalmanRequest request;
  request.model = {2, {0.5, 0.0, 0.0, 1.1}, {0.0}, {1.0, 0.0}};
  request.state = {"near", "far"};
  request.process = {0.1, 0.1};
  request.measured = {1.0};
  const KalmanDesign found = design_kalman(request);
  EXPECT_NE(found.problem.find("`far`"), std::string::npos) << found.problem;
}

TEST(Stein, IsTheSumOfPowers) {
  MatrixXd a(2, 2), q(2, 2);
  a << 0.9, 0.5, 0.0, -0.7;
  q << 2.0, 0.3, 0.3, 1.0;
  const MatrixXd x = solve_stein(a, q);
  EXPECT_LT((a * x * a.transpose() + q - x).norm(), 1e-13 * x.norm());
}

/// A plant that is another one in each of two phases.
PeriodicProblem two_phases() {
  PeriodicProblem problem;
  for (const double a : {1.1, 0.8}) {
    PeriodicPhase phase;
    phase.cost = {MatrixXd(2, 2), MatrixXd(2, 1), MatrixXd::Identity(2, 2), one(0.5),
                  MatrixXd::Zero(2, 1)};
    phase.cost.a << a, 0.1, 0.0, 0.95;
    phase.cost.b << 0.05, 0.2 * a;
    phase.c = MatrixXd::Identity(2, 2);
    problem.push_back(std::move(phase));
  }
  return problem;
}

TEST(Periodic, IsTheLimitOfTheRecursion) {
  const PeriodicProblem problem = two_phases();
  const auto found = solve_periodic(problem);
  ASSERT_TRUE(found);
  MatrixXd p = MatrixXd::Zero(2, 2);
  std::vector<MatrixXd> gain(2);
  for (int round = 0; round < 2000; ++round) {
    for (std::size_t i = 2; i-- > 0;) {
      const LinearQuadratic& here = problem[i].cost;
      const MatrixXd cross = here.b.transpose() * p * here.a;
      gain[i] = (here.r + here.b.transpose() * p * here.b).ldlt().solve(cross);
      p = (here.a.transpose() * p * here.a + here.q - cross.transpose() * gain[i]).eval();
    }
  }
  expect_near(found->gain[0], gain[0]);
  expect_near(found->gain[1], gain[1]);
  expect_near(found->p[0], p);
}

/// A mass whose speed costs and is received; its states are 0.9 times the position plus and minus
/// the speed, so that none of them is the position.
PeriodicProblem moving_mass(double decay) {
  MatrixXd map(2, 2), mixed(2, 2);
  map << 1.0, 0.01, 0.0, decay;
  mixed << 0.9, 1.0, 0.9, -1.0;
  const MatrixXd back = mixed.inverse();
  PeriodicPhase phase;
  phase.cost.a = mixed * map * back;
  phase.cost.b = mixed.col(1) * 0.01;
  phase.c = back.row(1);
  phase.cost.q = 4.0 * phase.c.transpose() * phase.c;
  phase.cost.r = one(1.0);
  phase.cost.s = MatrixXd::Zero(2, 1);
  return {phase, phase};
}

TEST(Hidden, APositionThatCostsNothingLeavesTheRegulatorOfTheSpeed) {
  PeriodicProblem problem = moving_mass(1.0);
  const MatrixXd hidden = hidden_modes(problem);
  ASSERT_EQ(hidden.cols(), 1);
  EXPECT_NEAR(std::abs(hidden.col(0).sum()), std::sqrt(2.0), 1e-12);  // along (1, 1)
  ASSERT_EQ(settle_hidden(problem).size(), 1U);
  const auto found = solve_periodic(problem);
  ASSERT_TRUE(found);
  for (const MatrixXd& gain : found->gain)
    expect_near(gain, scalar_gain(1.0, 0.01, 4.0, 1.0) * problem.front().c);
}

/// Chains of integrators behind the speed of a mass: its position, the integral of that, another
/// one that begins at the position, and of another speed that has its own controller and decays;
/// mixed, and in units that differ by factors of 1000.
PeriodicProblem integrators(std::size_t phases) {
  MatrixXd map = MatrixXd::Identity(6, 6);
  map(1, 0) = 0.02;   // position of speed
  map(2, 1) = 0.01;   // its integral
  map(3, 2) = 0.005;  // and of that
  map(4, 1) = -0.3;   // another integral of the position
  map(5, 5) = 0.7;
  map(5, 0) = 0.1;
  const MatrixXd mixed =
      (VectorXd(6) << 1.0, 1e3, 1e-3, 30.0, 1.0, 0.1).finished().asDiagonal() * reflection(6);
  const MatrixXd back = mixed.inverse();
  PeriodicPhase phase;
  phase.cost.a = mixed * map * back;
  phase.cost.b = mixed.col(0) * 0.05;
  phase.c = back.row(0);
  phase.cost.q = 9.0 * phase.c.transpose() * phase.c;
  phase.cost.r = one(2.0);
  phase.cost.s = MatrixXd::Zero(6, 1);
  return PeriodicProblem(phases, phase);
}

TEST(Hidden, ChainsOfIntegratorsLeaveTheRegulatorOfTheSpeed) {
  for (const std::size_t phases : {1U, 4U, 50U}) {
    PeriodicProblem problem = integrators(phases);
    EXPECT_FALSE(solve_periodic(problem)) << "as it is, their cost does not settle";
    ASSERT_EQ(hidden_modes(problem).cols(), 4) << phases << " phases; the fifth one decays";
    const auto free = settle_hidden(problem);
    EXPECT_EQ(free.size(), 4U);
    EXPECT_EQ(std::set<Index>(free.begin(), free.end()).size(), free.size());
    const auto found = solve_periodic(problem);
    ASSERT_TRUE(found);
    for (const MatrixXd& gain : found->gain)
      expect_near(gain, scalar_gain(1.0, 0.05, 9.0, 2.0) * problem.front().c);
  }
}

TEST(Hidden, AChainThatGrowsIsNoneOfIntegrators) {
  PeriodicProblem problem = integrators(1);
  // Poles 1 and 1.00001: by less than those of a chain scatter, but their mean is not 1.
  MatrixXd& a = problem.front().cost.a;
  a += 1e-5 * (a - MatrixXd::Identity(6, 6)) +
       1e-5 * hidden_modes(problem) * hidden_modes(problem).transpose();
  EXPECT_TRUE(settle_hidden(problem).empty());
}

TEST(Hidden, NothingIsSettledThatCostsOrIsReceivedOrGrows) {
  PeriodicProblem problem = moving_mass(1.0);
  for (PeriodicPhase& phase : problem) phase.c << 1.0, 0.0;
  EXPECT_TRUE(settle_hidden(problem).empty()) << "received";
  problem = moving_mass(1.0);
  problem.back().cost.q += 1e-3 * MatrixXd::Identity(2, 2);
  EXPECT_TRUE(settle_hidden(problem).empty()) << "costs in one phase";
  problem = moving_mass(1.0);
  const MatrixXd before = problem.front().cost.a;
  for (PeriodicPhase& phase : problem) phase.cost.a *= 1.01;
  EXPECT_TRUE(settle_hidden(problem).empty()) << "grows";
  EXPECT_EQ(problem.front().cost.a, 1.01 * before);
}

TEST(OutputFeedback, SlopeIsThatOfItsCost) {
  PeriodicProblem problem = two_phases();
  for (PeriodicPhase& phase : problem) phase.cost.s = MatrixXd::Constant(2, 1, 0.1);
  MatrixXd gain(1, 2);
  gain << 1.0, 1.5;
  const OutputFeedback at = output_feedback(problem, gain);
  ASSERT_LT(at.spectral_radius, 1.0);
  for (Index k = 0; k < 2; ++k) {
    constexpr double kStep = 1e-6;
    MatrixXd more = gain, less = gain;
    more(0, k) += kStep;
    less(0, k) -= kStep;
    const double slope =
        (output_feedback(problem, more).cost - output_feedback(problem, less).cost) / (2.0 * kStep);
    EXPECT_NEAR(at.slope(0, k), slope, 1e-6 * std::abs(slope) + 1e-7);
  }
}

TEST(OutputFeedback, OfTheWholeStateIsTheRegulator) {
  PeriodicProblem problem = two_phases();
  problem.pop_back();
  const auto regulator = solve_periodic(problem);
  ASSERT_TRUE(regulator);
  const auto found = least_output_feedback(problem, {MatrixXd::Zero(1, 2)});
  ASSERT_TRUE(found) << "from a gain that is not stable";
  EXPECT_LT((*found - regulator->gain[0]).norm(), 1e-5 * found->norm());
}

/// A pendulum upright, x'' = 30·x + u, whose motor lags by 0.05 s, over two ticks of 0.02 s
/// (Euler); position and speed are received, the motor's torque is not.
PeriodicProblem lagging_pendulum() {
  PeriodicPhase phase;
  phase.cost = {MatrixXd(3, 3), MatrixXd(3, 1), MatrixXd::Identity(3, 3), one(0.5),
                MatrixXd::Zero(3, 1)};
  phase.cost.a << 1.0, 0.02, 0.0, 0.6, 1.0, 0.02, 0.0, 0.0, 0.6;
  phase.cost.b << 0.0, 0.0, 0.4;
  phase.c = MatrixXd::Identity(2, 3);
  return {phase, phase};
}

TEST(SlowestPole, SlopeIsThatOfItsLogarithm) {
  const PeriodicProblem problem = lagging_pendulum();
  for (const double speed : {0.0, 20.0}) {  // a real pole, and a pair
    MatrixXd gain(1, 2);
    gain << 4.0 * speed, speed;
    const SlowestPole at = slowest_pole(problem, gain);
    for (Index k = 0; k < 2; ++k) {
      constexpr double kStep = 1e-6;
      MatrixXd more = gain, less = gain;
      more(0, k) += kStep;
      less(0, k) -= kStep;
      const double slope =
          (slowest_pole(problem, more).log_radius - slowest_pole(problem, less).log_radius) /
          (2.0 * kStep);
      EXPECT_NEAR(at.slope(0, k), slope, 1e-6 * std::abs(slope) + 1e-7) << speed;
    }
  }
}

TEST(OutputFeedback, BeginsAtGainsThatAreNotStable) {
  const PeriodicProblem problem = lagging_pendulum();
  MatrixXd start = MatrixXd::Zero(1, 2), best(1, 2);
  double least = 1e300;  // of all gains on a grid
  for (double position = 44.0; position < 51.0; position += 0.25) {
    for (double speed = 11.0; speed < 16.0; speed += 0.125) {
      MatrixXd gain(1, 2);
      gain << position, speed;
      const OutputFeedback at = output_feedback(problem, gain);
      if (!(at.spectral_radius < 1.0) || at.cost >= least) continue;
      least = at.cost;
      best = gain;
    }
  }
  ASSERT_LT(least, 1e299);
  for (const double sign : {1.0, -1.0}) {
    start *= sign;
    ASSERT_GT(output_feedback(problem, start).spectral_radius, 1.0);
    const auto found = least_output_feedback(problem, {start});
    ASSERT_TRUE(found) << start;
    EXPECT_LE(output_feedback(problem, *found).cost, least);
    EXPECT_LT((*found - best).norm(), 0.5) << *found << "\n" << best;
    start << 40.0, 5.0;
  }
}

TEST(OutputFeedback, TakesTheCheapestOfItsStarts) {
  const PeriodicProblem problem = lagging_pendulum();
  MatrixXd stable(1, 2);
  stable << 50.0, 8.0;
  const auto gains = stabilizing_gains(problem, {MatrixXd::Zero(1, 2), stable});
  ASSERT_EQ(gains.size(), 2U);
  EXPECT_EQ(gains[1], stable) << "it is stable already";
  EXPECT_LT(output_feedback(problem, gains[0]).spectral_radius, 1.0);
}

TEST(OutputFeedback, FindsNoneWhereThereIsNone) {
  PeriodicProblem problem = two_phases();
  for (PeriodicPhase& phase : problem) {
    phase.cost.a << 1.3, 0.0, 0.0, 1.3;
    phase.cost.b << 1.0, 0.0;
  }
  EXPECT_FALSE(least_output_feedback(problem, {MatrixXd::Zero(1, 2)}));
}

}  // namespace
}  // namespace eagerx::gen

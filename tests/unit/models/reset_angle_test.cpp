#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <models/nodes/reset_angle/reset_angle.hpp>
#include <models/nodes/reset_decomposed_angle/reset_decomposed_angle.hpp>

#include "tests/unit/models/entity_io.hpp"

namespace eagerx::models::testing {
namespace {

/// The controller as EAGERx's tutorials write it, on angles counted from hanging down.
class ResetReference {
 public:
  double next(double theta, double goal) {
    constexpr double kKp = 1.0, kKd = 0.5, kKi = 0.25, kDt = 1.0 / 30.0;
    const double factors[] = {kKp + kKi * kDt + kKd / kDt, -kKp - 2.0 * kKd / kDt, kKd / kDt};
    errors_.push_front(wrap(goal + M_PI) - wrap(theta + M_PI));
    if (errors_.size() > 3) errors_.pop_back();
    for (std::size_t i = 0; i < errors_.size(); ++i) u_ += factors[i] * errors_[i];
    return std::clamp(u_, -2.0, 2.0);
  }

 private:
  static double wrap(double angle) {
    return angle - 2.0 * M_PI * std::floor((angle + M_PI) / (2.0 * M_PI));
  }
  std::deque<double> errors_;
  double u_ = 0.0;
};

template <class Node, class Io>
struct Routine {
  Node node;
  Voltage u{};
  typename Io::Done done{};
  typename Io::Targets targets{};

  void call(Seq n, const typename Io::Inputs& in) {
    typename Io::Outputs out{u};
    node.callback({n}, in, targets, out, done);
  }
};
using AngleIo = ResetAngleIo<double>;
using InDouble = Routine<ResetAngle<AngleIo>, AngleIo>;

TEST(ResetAngle, IsTheTutorialsController) {
  InDouble run;
  run.node.reset({});
  run.targets.goal = {{3.0F, 5.0F}};  // the speed of the goal is not looked at
  ResetReference reference;
  for (Seq n = 100; n < 140; ++n) {
    const auto i = static_cast<float>(n) - 100.0F;
    const float theta = 3.2F + 0.05F * std::sin(0.3F * i);
    const float theta_dot = 1.0F;
    run.call(n, {{&theta, 1, 1}, {&theta_dot, 1, 1}});
    EXPECT_NEAR(run.u[0], reference.next(static_cast<double>(theta), 3.0), 1e-6) << n;
    EXPECT_FALSE(run.done.goal);
  }
}

TEST(ResetAngle, IsDoneWhenAngleAndSpeedAreNear) {
  const auto is_done = [](float theta, float theta_dot) {
    InDouble run;
    run.node.reset({});
    run.targets.goal = {{-3.0F, 0.0F}};
    run.call(7, {{&theta, 1, 1}, {&theta_dot, 1, 1}});
    return run.done.goal;
  };
  EXPECT_TRUE(is_done(-3.0F, 0.0F));
  EXPECT_TRUE(is_done(-3.09F, -0.09F));
  EXPECT_TRUE(is_done(3.25F, 0.05F));  // past hanging down, the same place
  EXPECT_FALSE(is_done(-3.11F, 0.0F));
  EXPECT_FALSE(is_done(-3.0F, 0.11F));
  EXPECT_FALSE(is_done(0.0F, 0.0F));
}

TEST(ResetAngle, GivesUpAfterTheTimeoutAndBeginsAnewAfterAReset) {
  InDouble run;
  const float theta = 0.0F, theta_dot = 0.0F;
  run.targets.goal = {{3.0F, 0.0F}};
  Seq n = 11;
  for (int episode = 0; episode < 2; ++episode) {
    run.node.reset({});
    const Seq start = n;
    do {
      run.call(n, {{&theta, 1, 1}, {&theta_dot, 1, 1}});
      if (n == start) {
        EXPECT_NEAR(run.u[0], 2.0F, 1e-6);  // nothing left of the last errors
      }
    } while (!run.done.goal && ++n < 1000);
    EXPECT_EQ(n - start, 151U);  // the first tick more than 5 s later
  }
}

TEST(ResetAngle, DoesNothingWithoutAGoal) {
  InDouble run;
  run.node.reset({});
  const float theta = 1.0F, theta_dot = 2.0F;
  run.u[0] = 9.0F;
  run.call(0, {{&theta, 1, 1}, {&theta_dot, 1, 1}});
  EXPECT_EQ(run.u[0], 0.0F);
  EXPECT_TRUE(run.done.goal);
}

TEST(ResetDecomposedAngle, IsTheSameOnCosineAndSine) {
  using Decomposed = ResetDecomposedAngleIo<double>;
  Routine<ResetDecomposedAngle<Decomposed>, Decomposed> run;
  InDouble plain;
  run.node.reset({});
  plain.node.reset({});
  run.targets.goal = plain.targets.goal = {{3.1F, 0.0F}};
  for (Seq n = 0; n < 30; ++n) {
    const float theta = 2.7F + 0.02F * static_cast<float>(n);
    const float theta_dot = 0.05F;
    const Array<float, 3> x{{std::cos(theta), std::sin(theta), theta_dot}};
    run.call(n, {{&x, 1, 1}});
    plain.call(n, {{&theta, 1, 1}, {&theta_dot, 1, 1}});
    EXPECT_NEAR(run.u[0], plain.u[0], 1e-4);
    EXPECT_EQ(run.done.goal, plain.done.goal);
  }
}

}  // namespace
}  // namespace eagerx::models::testing

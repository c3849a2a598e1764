// The method rodas4 of OdeEngine, and what it is made of.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <models/engines/ode_engine/lu.hpp>
#include <models/objects/dc_motor/dc_motor_ode.hpp>
#include <models/objects/test_pendulum/test_pendulum_ode.hpp>
#include <string>

#include "tests/firmware/entities/robertson/robertson_ode.hpp"
#include "tests/firmware/entities/van_der_pol/van_der_pol_ode.hpp"
#include "tests/unit/models/csv.hpp"
#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {
namespace {

template <class Real>
using Robertson = eagerx::tests::RobertsonOde<PendulumModelIo<Real>>;
template <class Real>
using VanDerPol = eagerx::tests::VanDerPolOde<PendulumModelIo<Real>>;

struct Rodas4Config : OdeConfig {
  static constexpr auto method = OdeMethod::rodas4;
};

/// The largest error of any state at the times of stiff.csv over the reference's own size, as it is
/// reached from one to the next. Noted as a property of the test (--gtest_output=xml).
template <class Model>
double largest_error(const std::string& problem, OdeState<Model> x, double until, double rtol,
                     double atol) {
  using Real = typename Model::Real;
  const OdeJacobian<Model> jacobian(Model::default_parameters(), {});
  Rodas4<OdeJacobian<Model>, Real, Model::kStates> method(jacobian);
  double worst = 0.0;
  double time = 0.0;
  Real next_step_s{};
  for (const Row& row : read_csv("stiff.csv")) {
    const double end = std::stod(row.at(1));
    if (row.at(0) != problem || end > until) continue;
    const auto span_s = static_cast<Real>(end - time);
    const AdaptiveSettings<Real> settings{static_cast<Real>(rtol), static_cast<Real>(atol), Real(0),
                                          span_s, 100000};
    EXPECT_EQ(integrate(method, x, span_s, next_step_s, settings), AdaptiveOutcome::done);
    time = end;
    for (std::size_t i = 0; i < Model::kStates; ++i) {
      const double exact = std::stod(row.at(2 + i));
      worst = std::max(worst, std::abs(static_cast<double>(x[i]) - exact) / std::abs(exact));
    }
  }
  EXPECT_EQ(time, until);
  std::array<char, 64> text{};
  static_cast<void>(std::snprintf(text.data(), text.size(), "%s_rtol_%g", problem.c_str(), rtol));
  const std::string name = text.data();
  static_cast<void>(std::snprintf(text.data(), text.size(), "%.1e", worst));
  ::testing::Test::RecordProperty(name, text.data());
  return worst;
}

TEST(Rodas4, FollowsRobertsonsReactionOverElevenDecades) {
  const auto error = [](double rtol) {
    return largest_error<Robertson<double>>("robertson", {{1.0, 0.0, 0.0}}, 1e11, rtol,
                                            rtol * 1e-14);
  };
  EXPECT_LT(error(1e-4), 3e-5);
  EXPECT_LT(error(1e-6), 2e-7);
  EXPECT_LT(error(1e-9), 3e-10);
}

TEST(Rodas4, FollowsRobertsonsReactionInFloat) {
  EXPECT_LT(largest_error<Robertson<float>>("robertson", {{1.0F, 0.0F, 0.0F}}, 1e4, 1e-5, 1e-10),
            1e-5);
}

TEST(Rodas4, FollowsVanDerPolsOscillatorOverItsJumps) {
  const auto error = [](double rtol) {
    return largest_error<VanDerPol<double>>("van_der_pol", {{2.0, 0.0}}, 2000.0, rtol, rtol * 1e-3);
  };
  EXPECT_LT(error(1e-6), 1e-5);
  EXPECT_LT(error(1e-9), 1e-8);
}

/// The references agree with what other programs found.
TEST(Rodas4, ReferencesAreThoseOfTheTestSet) {
  const auto rows = read_csv("stiff.csv");
  for (const Row& literature : rows) {
    if (literature[0].find("_literature") == std::string::npos) continue;
    bool found = false;
    for (const Row& row : rows) {
      if (row[0] + "_literature" != literature[0] || row[1] != literature[1]) continue;
      found = true;
      for (std::size_t i = 2; i < 5; ++i)
        EXPECT_NEAR(std::stod(row[i]), std::stod(literature[i]),
                    1e-11 * std::abs(std::stod(literature[i])));
    }
    EXPECT_TRUE(found) << literature[0];
  }
}

/// Robertson's reaction on the engine itself to t = 1e4, in ticks of 1000 s with the step kept.
struct TightConfig : Rodas4Config {
  static constexpr double rtol = 1e-6;
  static constexpr double atol = 1e-12;
};
TEST(OdeEngine, Rodas4FollowsRobertsonsReactionWithinItsFiveHundredSteps) {
  OdeSimulator<Robertson<double>> simulator;
  simulator.reset();
  simulator.state = {{1.0, 0.0, 0.0}};
  for (int i = 0; i < 10; ++i)
    tick<EngineIo<double, TightConfig, eagerx::Rate<1, 1000>>>(simulator);
  EXPECT_EQ(simulator.faults(), 0U);
  EXPECT_NEAR(simulator.state[0], 0.10730042853780447, 1e-7);
  EXPECT_NEAR(simulator.state[1], 4.800166972571665e-07, 1e-12);
  EXPECT_NEAR(simulator.state[2], 0.8926990914455005, 1e-7);
}

/// dopri5 cannot within the same number of steps: the problem is stiff.
struct ExplicitConfig : TightConfig {
  static constexpr auto method = OdeMethod::dopri5;
};
TEST(OdeEngine, Dopri5DoesNotFollowRobertsonsReaction) {
  OdeSimulator<Robertson<double>> simulator;
  simulator.reset();
  simulator.state = {{1.0, 0.0, 0.0}};
  tick<EngineIo<double, ExplicitConfig, eagerx::Rate<1, 1000>>>(simulator);
  EXPECT_EQ(simulator.faults(), 1U);
}

TEST(OdeEngine, Rodas4FollowsDopri5WhereNothingIsStiff) {
  auto implicit = PendulumSimulator<double>{};
  implicit.reset();
  implicit.state = {{-1.0, 9.0}};
  implicit.input = {{-2.0}};
  auto explicit_one = implicit;
  for (int i = 0; i < 30; ++i) {
    tick<EngineIo<double, Rodas4Config>>(implicit);
    tick<EngineIo<double>>(explicit_one);
    EXPECT_NEAR(implicit.state[0], explicit_one.state[0], 2e-6);
  }
  EXPECT_EQ(implicit.faults(), 0U);
}

struct FewImplicitSteps : Rodas4Config {
  static constexpr int mxstep = 3;
};
TEST(OdeEngine, Rodas4CountsWhatItCouldNotIntegrate) {
  OdeSimulator<Robertson<double>> simulator;
  simulator.reset();
  simulator.state = {{1.0, 0.0, 0.0}};
  tick<EngineIo<double, FewImplicitSteps>>(simulator);
  EXPECT_EQ(simulator.faults(), 1U);
  const auto before = simulator.state;
  simulator.input = {{std::numeric_limits<double>::quiet_NaN()}};
  tick<EngineIo<double, Rodas4Config>>(simulator);
  EXPECT_EQ(simulator.faults(), 2U);
  EXPECT_EQ(simulator.state, before) << "the last state that met the tolerances";
  simulator.input = {{0.0}};
  tick<EngineIo<double, Rodas4Config>>(simulator);
  EXPECT_EQ(simulator.faults(), 2U);
}

/// Error of `steps` equal steps over three seconds of van der Pol's oscillator with mu = 1.
double error_of_equal_steps(int steps) {
  using Model = VanDerPol<double>;
  const OdeJacobian<Model> jacobian({{1.0}}, {});
  const auto f = [&](const OdeState<Model>& x) { return jacobian.slope(x); };
  const auto end = [&](int count) {
    OdeState<Model> x{{2.0, 0.0}};
    for (int i = 0; i < count; ++i)
      x = Rodas4Step<double, 2>(f, x, f(x), jacobian(x), 3.0 / count).end;
    return x;
  };
  const auto exact = end(8192);
  const auto found = end(steps);
  return std::hypot(found[0] - exact[0], found[1] - exact[1]);
}
TEST(Rodas4, IsOfFourthOrder) {
  const double coarse = error_of_equal_steps(256);
  EXPECT_GT(coarse, 5e-10);  // far above what is rounded
  EXPECT_NEAR(std::log2(coarse / error_of_equal_steps(512)), 4.0, 0.1);
}
TEST(Rodas4, EstimatesAnErrorOfThirdOrder) {
  using Model = VanDerPol<double>;
  const OdeJacobian<Model> jacobian({{5.0}}, {});
  const auto f = [&](const OdeState<Model>& x) { return jacobian.slope(x); };
  const OdeState<Model> x{{1.8, -0.1}};
  const auto estimate = [&](double step_s) {
    return std::abs(Rodas4Step<double, 2>(f, x, f(x), jacobian(x), step_s).error[1]);
  };
  using Method = Rodas4<OdeJacobian<Model>, double, 2>;
  EXPECT_NEAR(std::log2(estimate(0.02) / estimate(0.01)), Method::kErrorOrder, 0.3);
}
/// Steps over one period of van der Pol's oscillator with mu = 1000.
double steps_of_stiff(double rtol) {
  using Model = VanDerPol<double>;
  const OdeJacobian<Model> jacobian({{1000.0}}, {});
  struct Counted : Rodas4<OdeJacobian<Model>, double, 2> {
    using Rodas4<OdeJacobian<Model>, double, 2>::Rodas4;
    void go_on(const Rodas4Step<double, 2>& step) {
      ++steps;
      Rodas4<OdeJacobian<Model>, double, 2>::go_on(step);
    }
    int steps = 0;
  };
  Counted method(jacobian);
  OdeState<Model> x{{2.0, 0.0}};
  double next_step_s = 0.0;
  const AdaptiveSettings<double> settings{rtol, rtol * 1e-3, 0.0, 2000.0, 100000};
  EXPECT_EQ(integrate(method, x, 2000.0, next_step_s, settings), AdaptiveOutcome::done);
  return method.steps;
}
/// Fourth order takes 10^(1/4) = 1.78 times the steps for a decade of the tolerance. Methods that
/// lose their order on stiff equations take up to 2.5 times (RODAS with METH=1).
TEST(Rodas4, KeepsItsOrderOnStiffEquations) {
  EXPECT_LT(steps_of_stiff(1e-8) / steps_of_stiff(1e-7), 2.0);
  EXPECT_LT(steps_of_stiff(1e-10) / steps_of_stiff(1e-9), 2.0);
}
/// A step of any length over dx/dt = −x·1e9 ends near 0: R(∞) = 0.
TEST(Rodas4, IsLStable) {
  const auto f = [](const Array<double, 1>& x) { return Array<double, 1>{{-1e9 * x[0]}}; };
  const Array<double, 1> x{{1.0}};
  const Rodas4Step<double, 1> step(f, x, f(x), {-1e9}, 1.0);
  EXPECT_LT(std::abs(step.end[0]), 1e-7);
  EXPECT_LT(std::abs(step.error[0]), 1e-7);
}

TEST(Lu, SolvesWithPivots) {
  const std::array<double, 9> a = {0.0, 2.0, 1.0, 1e-20, 1.0, 1.0, 4.0, -1.0, 3.0};
  const auto x = Lu<double, 3>(a).solve({{7.0, 5.0, 11.0}});
  EXPECT_NEAR(2.0 * x[1] + x[2], 7.0, 1e-14);
  EXPECT_NEAR(x[1] + x[2], 5.0, 1e-14);
  EXPECT_NEAR(4.0 * x[0] - x[1] + 3.0 * x[2], 11.0, 1e-14);
}
TEST(Lu, OfASingularMatrixGivesNoFiniteSolution) {
  const auto x = Lu<double, 2>({1.0, 2.0, 2.0, 4.0}).solve({{1.0, 1.0}});
  EXPECT_FALSE(std::isfinite(x[0]) && std::isfinite(x[1]));
}

/// A model without its Jacobian, so that it is computed with dual numbers or differences.
template <template <class> class Model, class Io, bool Duals>
struct Without {
  using Real = typename Io::Real;
  using Whole = Model<Io>;
  static constexpr std::size_t kStates = Whole::kStates;
  static constexpr std::size_t kInputs = Whole::kInputs;
  static constexpr std::size_t kParameters = Whole::kParameters;
  static constexpr bool dual_numbers = Duals;
  static constexpr auto default_parameters() { return Whole::default_parameters(); }
  static constexpr auto derivative(const Array<Real, kParameters>& p, const Array<Real, kInputs>& u,
                                   Array<Real, kStates> x) {
    return Whole::derivative(Whole::precompute(p, u), x);
  }
};
template <class Io>
struct PendulumWithout : Without<PendulumOde, Io, true> {};
template <class Io>
struct PendulumWithDifferences : Without<PendulumOde, Io, false> {};
template <class Io>
struct MotorWithout : Without<DcMotorOde, Io, true> {};
template <class Io>
struct TestPendulumWithout : Without<TestPendulumOde, Io, true> {};

/// The largest difference between the Jacobians of two models over that of the first, in units of
/// the resolution.
template <class Model, class Other>
double largest_difference() {
  using Real = typename Model::Real;
  double worst = 0.0;
  for (const double theta : {-3.0, -0.4, 0.0, 1.0, 2.5}) {
    for (const double omega : {-9.0, -0.02, 0.0, 0.003, 5.0}) {
      const OdeState<Model> x{{static_cast<Real>(theta), static_cast<Real>(omega)}};
      const auto p = Model::default_parameters();
      const OdeInputs<Model> u{{Real(1.5)}};
      const auto own = OdeJacobian<Model>(p, u)(x);
      const auto other = OdeJacobian<Other>(p, u)(x);
      for (std::size_t i = 0; i < own.size(); ++i) {
        const double size = std::max(1.0, std::abs(static_cast<double>(own[i])));
        worst = std::max(worst, std::abs(static_cast<double>(own[i] - other[i])) / size);
      }
    }
  }
  return worst / static_cast<double>(std::numeric_limits<Real>::epsilon());
}

template <class Real>
void expect_exact_jacobians() {
  using Io = PendulumModelIo<Real>;
  EXPECT_LE((largest_difference<PendulumOde<Io>, PendulumWithout<Io>>()), 4.0);
  EXPECT_LE((largest_difference<DcMotorOde<Io>, MotorWithout<Io>>()), 4.0);
  EXPECT_LE((largest_difference<TestPendulumOde<Io>, TestPendulumWithout<Io>>()), 4.0);
}
TEST(OdeJacobian, OfDualNumbersIsTheAnalyticOne) {
  expect_exact_jacobians<double>();
  expect_exact_jacobians<float>();
}
TEST(OdeJacobian, IsOfDifferencesWhereTheModelAsksForThem) {
  using Io = PendulumModelIo<double>;
  const double difference = largest_difference<PendulumOde<Io>, PendulumWithDifferences<Io>>();
  EXPECT_GT(difference, 100.0);
  EXPECT_LT(difference * std::numeric_limits<double>::epsilon(), 1e-6);
}

}  // namespace
}  // namespace eagerx::models::testing

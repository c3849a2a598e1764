// The curves of a loop: of an integrator with proportional control they have closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generator/tools/linear/loop_curves.hpp"
#include "generator/tools/linear/loop_svg.hpp"
#include "tests/unit/linear/integrator.hpp"

namespace eagerx::gen {
namespace {

// x' = (1 − k·h)·x + k·h after a step: T = x = 1 − (1 − k·h)^n, S = 1 − T.
TEST(StepResponse, OfAnIntegrator) {
  for (const std::size_t messages : {1U, 3U}) {
    const std::vector<StepSample> samples = step_response_of(integrator(messages));
    ASSERT_GE(samples.size(), 40U);
    for (std::size_t n = 0; n < samples.size(); ++n) {
      const double left = std::pow(1.0 - kGain * kPeriod, static_cast<double>(n));
      EXPECT_NEAR(samples[n].time_s, kPeriod * static_cast<double>(n), 1e-12);
      EXPECT_NEAR(samples[n].returned, 1.0 - left, 1e-12);
      EXPECT_NEAR(samples[n].sent, left, 1e-12);
    }
    EXPECT_LT(samples.back().sent, 0.01) << "it has not settled";
  }
}

TEST(StepResponse, EndsWhereAnUnstableLoopGrows) {
  SampledSystem system = integrator(1);
  system.c = {{1.0}};  // positive feedback: x' = (1 + k·h)·x + k·h
  const std::vector<StepSample> samples = step_response_of(system);
  EXPECT_GT(samples.back().sent, 100.0);
  EXPECT_TRUE(std::isfinite(samples.back().sent));
}

LoopCurves curves_of_integrator(std::size_t messages) {
  const SampledSystem system = integrator(messages);
  return loop_curves_of({&system, modes_of(system), margins_of(system), "controller.u", {}, {}});
}

TEST(LoopCurves, PolesAndPhase) {
  const LoopCurves curves = curves_of_integrator(1);
  ASSERT_EQ(curves.closed_poles.size(), 1U);
  EXPECT_NEAR(curves.closed_poles[0].real(), 1.0 - kGain * kPeriod, 1e-12);
  ASSERT_EQ(curves.open_poles.size(), 1U);
  EXPECT_EQ(curves.open_poles[0], 1.0);
  // −90° − ω·h/2, without a jump.
  for (const BodePoint& each : curves.bode)
    EXPECT_NEAR(each.phase_deg, -90.0 - 180.0 * each.frequency_hz * kPeriod, 1e-6);
}

// L = k·h/(z²·(z − 1)) turns beyond −180°, which arg() would show as a jump to +180°.
TEST(LoopCurves, PhaseGoesBeyondHalfATurn) {
  SampledSystem system = integrator(1);
  system.state = {{"x", 0.0}, {"one", 0.0}, {"two", 0.0}};
  system.a = {{1.0, 0.0, kGain * kPeriod}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  system.b = {{0.0}, {1.0}, {0.0}};
  system.c = {{-1.0, 0.0, 0.0}};
  const LoopCurves curves =
      loop_curves_of({&system, modes_of(system), margins_of(system), "controller.u", {}, {}});
  for (const BodePoint& each : curves.bode)
    EXPECT_NEAR(each.phase_deg, -90.0 - 5.0 * 180.0 * each.frequency_hz * kPeriod, 1e-6);
}

// Three integrators with two zeros: L begins at −270°, which arg() returns as 90°.
TEST(LoopCurves, ThePhaseMarginIsFromMinusHalfATurn) {
  SampledSystem system = integrator(1);
  system.state = {{"x", 0.0}, {"v", 0.0}, {"a", 0.0}};
  system.a = {{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, -3.0, 3.0}};
  system.b = {{0.0}, {0.0}, {1.0}};
  system.c = {{-0.5 * 0.8 * 0.8, 0.5 * 2.0 * 0.8, -0.5}};
  const Margins margins = margins_of(system);
  ASSERT_TRUE(margins.is_stable && margins.phase_deg);
  const LoopCurves curves = loop_curves_of({&system, modes_of(system), margins, "u", {}, {}});
  const auto near =
      std::ranges::lower_bound(curves.bode, *margins.crossover_hz, {}, &BodePoint::frequency_hz);
  EXPECT_NEAR(near->phase_deg, *margins.phase_deg - 180.0, 3.0);
  EXPECT_NEAR(curves.bode.front().phase_deg, -270.0, 1.0);
}

// The integrator itself, with a step of 0.5 on a message that is 2 without it; from the tenth
// message on it sends half as much.
TEST(LoopCurves, SimulatedStepIsDividedByItsSize) {
  LoopCurves curves = curves_of_integrator(1);
  const double size = 0.5;
  std::vector<double> with, without(step_messages(curves), 2.0);
  double x = 0.0;
  for (std::size_t i = 0; i < without.size(); ++i) {
    const double y = i < 10 ? -x : -0.5 * x;
    with.push_back(2.0 + y);
    x += kGain * kPeriod * (y + size);
  }
  add_simulated_step(with, without, size, "V", curves);
  const auto& [found_size, unit, step, difference] = curves.simulated;
  ASSERT_EQ(step.size(), curves.step.size());
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_NEAR(step[i].returned, curves.step[i].returned, 1e-12);
    EXPECT_NEAR(step[i].sent, curves.step[i].sent, 1e-12);
  }
  const double half = curves.step[10].returned / 2.0;
  EXPECT_NEAR(step[10].returned, half, 1e-12);
  EXPECT_GE(difference, half - 1e-12) << "the largest of all messages";
  EXPECT_NE(dump_json(loop_curves_json(curves)).find("\"V\""), std::string::npos);
  EXPECT_NE(loop_svg(curves, "robot").find("a step of 0.5 V"), std::string::npos);
  // The program has diverged: what it sent until then.
  with.resize(3);
  add_simulated_step(with, without, size, "", curves);
  EXPECT_EQ(curves.simulated.step.size(), 3U);
}

TEST(LoopCurves, PictureNamesPortAndMargins) {
  const LoopCurves curves = curves_of_integrator(3);
  const std::string text = loop_svg(curves, "robot <1>");
  EXPECT_NE(text.find("robot &lt;1&gt;"), std::string::npos);
  EXPECT_NE(text.find("controller.u"), std::string::npos);
  EXPECT_NE(text.find("84.3 deg"), std::string::npos) << "the phase margin, 90° − asin(k·h/2)";
  EXPECT_NE(text.find("closed loop stable, gain margin 20 dB"), std::string::npos);
  for (const char* const axis : {"frequency [Hz]", "imaginary part", "time [s]"})
    EXPECT_NE(text.find(axis), std::string::npos) << axis;
  EXPECT_NE(text.find("20 dB"), std::string::npos) << "the gain margin, 2/(k·h)";
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  EXPECT_EQ(text.find("simulated"), std::string::npos) << "no program has run";
}

}  // namespace
}  // namespace eagerx::gen

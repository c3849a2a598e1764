// An integrator with proportional control: its poles and margins have closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "generator/tools/linear/modes.hpp"
#include "tests/unit/linear/integrator.hpp"

namespace eagerx::gen {
namespace {

// L = k·h/(z − 1): |L| = k·h/(2·sin(ω·h/2)), its phase −90° − ω·h/2.
void expect_margins_of_integrator(const Margins& margins) {
  const double half = std::asin(kGain * kPeriod / 2.0);  // ω·h/2 at the crossover
  const double w = 2.0 * half / kPeriod;
  EXPECT_TRUE(margins.is_stable);
  EXPECT_NEAR(*margins.crossover_hz, w / (2.0 * kPi), 1e-9);
  EXPECT_NEAR(*margins.phase_deg, 90.0 - half * 180.0 / kPi, 1e-9);
  EXPECT_NEAR(*margins.delay_s, (kPi / 2.0 - half) / w, 1e-12);
  // At half of the rate of the messages the phase is −180° and the gain k·h/2.
  ASSERT_TRUE(margins.gain);
  EXPECT_NEAR(*margins.gain, 2.0 / (kGain * kPeriod), 1e-9);
  EXPECT_NEAR(*margins.gain_frequency_hz, 0.5 / kPeriod, 1e-9);
  ASSERT_TRUE(margins.stable_messages);
  EXPECT_EQ(*margins.stable_messages, static_cast<std::size_t>(*margins.delay_s / kPeriod));
  EXPECT_LT(margins.other_frequencies, 1e-9);
}

TEST(Margins, OfAnIntegrator) {
  const Margins margins = margins_of(integrator(1));
  EXPECT_DOUBLE_EQ(margins.spectral_radius, 1.0 - kGain * kPeriod);
  EXPECT_DOUBLE_EQ(margins.port_period_s, kPeriod);
  expect_margins_of_integrator(margins);
}

TEST(Margins, PolesNextTo1AreCountedApart) {
  SampledSystem system = integrator(1);
  EXPECT_EQ(margins_of(system).integrators, 0U);
  system.state.push_back({"grows", 0.0});
  system.a = {{1.0, 0.0}, {0.0, 1.0 + 5e-7}};
  system.b.push_back({0.0});
  system.c.front().push_back(0.0);
  const Margins margins = margins_of(system);
  EXPECT_TRUE(margins.is_stable);
  EXPECT_EQ(margins.integrators, 1U);
  EXPECT_DOUBLE_EQ(margins.spectral_radius, 1.0 - kGain * kPeriod);
}

TEST(Margins, SeveralMessagesOfAHyperperiodAreOneLoop) {
  const Margins margins = margins_of(integrator(3));
  EXPECT_NEAR(margins.spectral_radius, std::pow(1.0 - kGain * kPeriod, 3), 1e-12);
  EXPECT_NEAR(margins.port_period_s, kPeriod, 1e-15);
  expect_margins_of_integrator(margins);
}

TEST(Margins, GainOfALoopWithADelay) {
  // L = k·h/(z·(z − 1)): −90° − 3·ω·h/2 is −180° at ω·h = π/3, where |L| = k·h.
  SampledSystem system = integrator(1);
  system.state.push_back({"sent", 0.0});
  system.a = {{1.0, kGain * kPeriod}, {0.0, 0.0}};
  system.b = {{0.0}, {1.0}};
  system.c = {{-1.0, 0.0}};
  const Margins margins = margins_of(system);
  EXPECT_NEAR(*margins.gain, 1.0 / (kGain * kPeriod), 1e-9);
  EXPECT_NEAR(*margins.gain_frequency_hz, 1.0 / (6.0 * kPeriod), 1e-9);
}

/// x' = 1.2·x + u, y = −gain·x: stable for gains between 0.2 and 2.2.
SampledSystem balanced(double gain) {
  SampledSystem system;
  system.period_s = kPeriod;
  system.state = {{"x", 0.0}};
  system.opened = 1;
  system.inputs = system.outputs = {{"y", "", 0, 0}};
  system.a = {{1.2}};
  system.b = {{1.0}};
  system.c = {{-gain}};
  system.d = {{0.0}};
  return system;
}

TEST(Margins, LeastGainOfWhatFallsIsThatAtRest) {
  const Margins margins = margins_of(balanced(0.5));
  EXPECT_TRUE(margins.is_stable);
  ASSERT_TRUE(margins.least_gain);
  EXPECT_NEAR(*margins.least_gain, 0.2 / 0.5, 1e-12);
  EXPECT_EQ(*margins.least_gain_frequency_hz, 0.0);
  ASSERT_TRUE(margins.gain);
  EXPECT_NEAR(*margins.gain, 2.2 / 0.5, 1e-9);
}

TEST(Margins, WhatIsNotStableBearsNoDelay) {
  const Margins margins = margins_of(balanced(0.19));
  EXPECT_FALSE(margins.is_stable);
  EXPECT_FALSE(margins.delay_s);
  EXPECT_FALSE(margins.stable_messages);
}

TEST(Margins, ResponsesAreThoseOfTheLoop) {
  for (const Response& each : responses_of(integrator(3), 50)) {
    const double half = kPi * each.frequency_hz * kPeriod;
    EXPECT_NEAR(std::abs(each.loop) * 2.0 * std::sin(half) / (kGain * kPeriod), 1.0, 1e-9);
  }
}

TEST(Modes, OfAnOscillator) {
  // A turn by ω·h that shrinks by exp(−σ·h).
  constexpr double kSigma = 2.0, kOmega = 30.0;
  const double r = std::exp(-kSigma * kPeriod), angle = kOmega * kPeriod;
  SampledSystem system;
  system.period_s = kPeriod;
  system.state = {{"position", 0.0}, {"speed", 0.0}, {"message", 0.0}};
  system.a = {{r * std::cos(angle), -r * std::sin(angle), 0.0},
              {r * std::sin(angle), r * std::cos(angle), 0.0},
              {1.0, 0.0, 0.0}};
  const Modes modes = modes_of(system);
  EXPECT_NEAR(modes.spectral_radius, r, 1e-14);
  ASSERT_EQ(modes.poles.size(), 1U);
  EXPECT_EQ(modes.at_zero, 1U);
  EXPECT_NEAR(modes.poles[0].frequency_hz, std::hypot(kSigma, kOmega) / (2.0 * kPi), 1e-12);
  EXPECT_NEAR(modes.poles[0].damping, kSigma / std::hypot(kSigma, kOmega), 1e-12);
  EXPECT_NEAR(modes.poles[0].time_constant_s, 1.0 / kSigma, 1e-12);
  ASSERT_EQ(modes.poles[0].participation.size(), 2U);
  EXPECT_NEAR(modes.poles[0].participation[0].share, 0.5, 1e-12);
}

}  // namespace
}  // namespace eagerx::gen

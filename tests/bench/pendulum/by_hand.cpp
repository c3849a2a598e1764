// The same graph as a careful engineer would write it: one loop, everything in local variables. The
// operations and their order are those of the entities, so that the bits must be equal.
#include <eagerx/math.hpp>
#include <models/nodes/butterworth_filter/butterworth_design.hpp>

#include "loops.hpp"
#include "pendulum_swing_up/policy.hpp"

namespace eagerx::bench {
namespace {

constexpr double kRateHz = 30.0;
constexpr int kSubsteps = 30;
constexpr auto kStepS = static_cast<float>(1.0 / kRateHz / kSubsteps);
constexpr float kHalfStepS = kStepS * 0.5F;
constexpr float kSixthStepS = kStepS * static_cast<float>(1.0 / 6.0);

// The pendulum, divided by its inertia.
constexpr float kPerInertia = 1.0F / 0.000159931461600856F;
constexpr float kMotorConstant = 0.0333391179016334F;
constexpr float kMotorOverResistance = kMotorConstant / 7.73125142447252F;
constexpr float kGravity = 0.0508581731919534F * 9.81F * 0.0415233722862552F * kPerInertia;
constexpr float kDamping =
    (1.43298488358436e-05F + kMotorConstant * kMotorOverResistance) * kPerInertia;
constexpr float kFriction = 0.000975041213361349F * kPerInertia;
constexpr float kFrictionSlope = 165.417960777425F * 0.5F;

constexpr float kMostVolt = 2.0F;

constexpr models::SecondOrderSection kFilter =
    models::design_butterworth(2, models::FilterType::lowpass, 12.0, 12.0, kRateHz).sections[0];
constexpr auto kB0 = static_cast<float>(kFilter.b0);
constexpr auto kB1 = static_cast<float>(kFilter.b1);
constexpr auto kB2 = static_cast<float>(kFilter.b2);
constexpr auto kA1 = static_cast<float>(kFilter.a1);
constexpr auto kA2 = static_cast<float>(kFilter.a2);

}  // namespace

Seen run_by_hand(bool policy, std::uint64_t steps) {
  float theta = kTheta;
  float omega = kThetaDot;
  float z1 = 0.0F;
  float z2 = 0.0F;
  Seen seen{eagerx::cos(theta), eagerx::sin(theta), omega};
  for (std::uint64_t step = 0; step < steps; ++step) {
    float action = 0.0F;
    if (policy) {
      const float input[] = {seen.cosine, seen.sine, seen.theta_dot};
      float output[1];
      graphs::pendulum_swing_up::policy::evaluate(input, output);
      action = -kMostVolt + (0.5F * (output[0] + 1.0F)) * (kMostVolt + kMostVolt);
    }
    const float voltage = kB0 * action + z1;
    z1 = kB1 * action - kA1 * voltage + z2;
    z2 = kB2 * action - kA2 * voltage;

    const float motor = kMotorOverResistance * voltage * kPerInertia;
    const auto slope = [motor](float angle, float speed) {
      return motor + kGravity * eagerx::sin(angle) - kDamping * speed -
             kFriction * eagerx::tanh(kFrictionSlope * speed);
    };
    for (int i = 0; i < kSubsteps; ++i) {
      const float v1 = omega;
      const float a1 = slope(theta, v1);
      const float v2 = omega + kHalfStepS * a1;
      const float a2 = slope(theta + kHalfStepS * v1, v2);
      const float v3 = omega + kHalfStepS * a2;
      const float a3 = slope(theta + kHalfStepS * v2, v3);
      const float v4 = omega + kStepS * a3;
      const float a4 = slope(theta + kStepS * v3, v4);
      theta = theta + kSixthStepS * (v1 + 2.0F * v2 + 2.0F * v3 + v4);
      omega = omega + kSixthStepS * (a1 + 2.0F * a2 + 2.0F * a3 + a4);
    }
    seen = {eagerx::cos(theta), eagerx::sin(theta), omega};
  }
  return seen;
}

}  // namespace eagerx::bench

// FloatingBaseObserver against the motion of a simulated walker, and against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <eagerx/simd.hpp>
#include <models/nodes/floating_base_observer/floating_base_observer.hpp>

#include "tests/unit/models/block_harness.hpp"
#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/multibody/robot_block_io.hpp"
#include "tests/unit/multibody/robots.hpp"
#include "tests/unit/multibody/sampler.hpp"

namespace eagerx::models::testing::robots {
namespace {

using blocks::kNan;
using blocks::window;

struct Outputs {
  std::array<double, 4> attitude;
  std::array<double, 3> velocity, angular_velocity, gravity;
};
template <class Io, std::size_t N, std::size_t Feet>
Outputs tick(FloatingBaseObserver<Io>& node, const std::array<double, N>& q,
             const std::array<double, N>& v, const std::array<double, Feet>& contacts,
             const std::array<double, 6>& imu) {
  using Real = typename Io::Real;
  const auto message = [](const auto& x) {
    Array<Real, std::tuple_size_v<std::remove_cvref_t<decltype(x)>>> y{};
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = static_cast<Real>(x[i]);
    return y;
  };
  const auto of_q = message(q), of_v = message(v);
  const auto of_contacts = message(contacts);
  const auto of_imu = message(imu);
  Array<Real, 4> attitude{};
  Array<Real, 3> velocity{}, angular_velocity{}, gravity{};
  typename Io::Outputs out{attitude, velocity, angular_velocity, gravity};
  node.callback({0}, {window(of_q), window(of_v), window(of_contacts), window(of_imu)}, out);
  const auto numbers = []<std::size_t M>(const Array<Real, M>& x) {
    std::array<double, M> y{};
    for (std::size_t i = 0; i < M; ++i) y[i] = static_cast<double>(x[i]);
    return y;
  };
  return {numbers(attitude), numbers(velocity), numbers(angular_velocity), numbers(gravity)};
}
template <class Node>
std::array<unsigned, 2> counts(const Node& node) {  // restarts, slips
  std::array<unsigned, 2> all{};
  std::size_t i = 0;
  node.for_each_count([&](const char*, std::uint32_t count) { all[i++] = count; });
  return all;
}

// ---- two legs that stand, by hand
using Legs = TwoLegs<double>;
using LegsIo = ObserverIo<double, ObserverConfig<Legs>, 2, 2>;
using PerLeg = std::array<double, 2>;
constexpr PerLeg kZero{}, kBoth{1.0, 1.0};
constexpr double kG = 9.81;

TEST(FloatingBase, FindsTiltAndBiasOfARobotThatStands) {
  FloatingBaseObserver<LegsIo> node;
  node.reset({});
  // Rolled by 0.2 rad; the first sample is 0.1 rad off, as while it moves.
  const double roll = 0.2;
  const std::array<double, 3> bias = {0.03, -0.02, 0.01};
  Outputs y{};
  for (int n = 0; n < 2000; ++n) {  // 20 s
    const double at = n == 0 ? 0.1 : roll;
    y = tick(node, kZero, kZero, kBoth,
             {0.0, kG * std::sin(at), kG * std::cos(at), bias[0], bias[1], bias[2]});
  }
  EXPECT_NEAR(y.gravity[0], 0.0, 1e-3);
  EXPECT_NEAR(y.gravity[1], -std::sin(roll), 1e-3);
  EXPECT_NEAR(y.gravity[2], -std::cos(roll), 1e-3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(y.velocity[i], 0.0, 1e-3);
    EXPECT_NEAR(y.angular_velocity[i], 0.0, 1e-3) << "the bias is known, about all axes";
  }
  // The rotation from body to world: Rᵀ·(−z) is the direction of gravity.
  const auto [w, a, b, c] = y.attitude;
  EXPECT_NEAR(w * w + a * a + b * b + c * c, 1.0, 1e-12);
  EXPECT_NEAR(2.0 * (b * c + w * a), std::sin(roll), 1e-3);
  EXPECT_EQ(counts(node), (std::array<unsigned, 2>{0, 0}));
}

TEST(FloatingBase, VelocityIsThatOfTheStandingLeg) {
  // Both hips turn at 1 rad/s, so the trunk moves against its feet: hinges about y only.
  FloatingBaseObserver<LegsIo> node;
  node.reset({});
  Outputs y{};
  for (int n = 0; n < 200; ++n)
    y = tick(node, kZero, PerLeg{0.5, 0.0}, PerLeg{1.0, 0.0}, {0.0, 0.0, kG, 0.0, 0.0, 0.0});
  // The lowest point of the left foot is 0.63 m below the hip; w x p = 0.5 * (-0.63, 0, 0).
  EXPECT_NEAR(y.velocity[0], 0.5 * 0.63, 0.02);
  EXPECT_NEAR(y.velocity[2], 0.0, 0.02);
}

TEST(FloatingBase, FeetThatSlipAreLeftOut) {
  FloatingBaseObserver<LegsIo> node;
  node.reset({});
  const std::array<double, 6> still = {0.0, 0.0, kG, 0.0, 0.0, 0.0};
  for (int n = 0; n < 200; ++n) tick(node, kZero, kZero, kBoth, still);
  Outputs y{};
  for (int n = 0; n < 100; ++n) y = tick(node, kZero, PerLeg{0.0, 4.0}, kBoth, still);
  EXPECT_EQ(counts(node), (std::array<unsigned, 2>{0, 100}));
  for (const double v : y.velocity) EXPECT_NEAR(v, 0.0, 0.01);
  // Both of them: it does not believe in its estimate for longer than `patience`.
  for (int n = 0; n < 60; ++n) y = tick(node, PerLeg{0.3, 0.3}, PerLeg{8.0, 8.0}, kBoth, still);
  EXPECT_EQ(counts(node)[0], 1U);
}

TEST(FloatingBase, WhatIsNotFiniteChangesNothingForLong) {
  FloatingBaseObserver<LegsIo> node;
  node.reset({});
  const std::array<double, 6> still = {0.0, 0.0, kG, 0.0, 0.0, 0.0};
  Outputs before = tick(node, kZero, kZero, kBoth, {kNan<double>, 0.0, kG, 0.0, 0.0, 0.0});
  EXPECT_EQ(before.attitude, (std::array<double, 4>{1.0, 0.0, 0.0, 0.0}));
  for (int n = 0; n < 100; ++n) before = tick(node, kZero, PerLeg{0.2, 0.1}, kBoth, still);
  const Outputs held = tick(node, kZero, PerLeg{9.0, 9.0}, kBoth, {0, 0, kG, 0, kNan<double>, 0});
  EXPECT_EQ(held.velocity, before.velocity);
  EXPECT_EQ(held.attitude, before.attitude);
  const Outputs alone = tick(node, PerLeg{kNan<double>, 0.0}, kZero, kBoth, {1.0, 0, kG, 0, 0, 0});
  EXPECT_NEAR(alone.velocity[0], before.velocity[0] + 0.01, 1e-3) << "the IMU predicts";
  EXPECT_EQ(counts(node), (std::array<unsigned, 2>{0, 0}));
}

// ---- a walker of twelve joints that trots and is pushed
using Body = WalkerOf<double>;
struct WalkerConfig : ObserverConfig<Body> {
  static constexpr const char* feet = "fl_foot fr_foot rl_foot rr_foot";
};
using Twelve = std::array<double, 12>;
using PerFoot = std::array<double, 4>;

/// At 200 Hz, in steps of 5 ms.
struct Walking {
  using Io = EngineIo<double, MultibodyConfig<1>, eagerx::Rate<200>>;
  MultibodySimulator<Body> simulator{};
  MultibodyEngine<Io> engine{};
  int n = 0;

  Walking() {
    eagerx::start(engine, simulator);
    for (std::size_t j = 0; j < 12; ++j)
      simulator.want_joint(j, {{j % 3 == 1 ? 0.9 : j % 3 == 2 ? -1.8 : 0.0, 0.0}, {0.0, 0.0}});
    simulator.want_pose(0, {{0.0, 0.0041, 0.27, 1.0, 0.0, 0.0, 0.0}});
    eagerx::reset_engine(engine, NoStates{}, simulator);
  }
  /// Diagonal legs lift in turn, twice a second, and swing.
  void tick() {
    const double t = 0.005 * n++, blend = std::min(1.0, 0.5 * t);
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const double phase = 12.566370614 * t + (leg == 0 || leg == 3 ? 0.0 : 3.14159265);
      const double lift = blend * std::max(0.0, std::sin(phase)), swing = blend * std::cos(phase);
      const double target[3] = {0.0, 0.9 + 0.3 * lift + 0.15 * swing, -1.8 - 0.5 * lift};
      for (std::size_t i = 0; i < 3; ++i)
        simulator.set_joint_servo(3 * leg + i, {target[i], 60.0, 1.5, 33.5});
    }
    const bool pushes = n % 400 < 40;
    simulator.set_force(0, {{pushes ? 15.0 : 0.0, pushes ? -20.0 : 0.0, 0.0}});
    engine.callback({1}, simulator);
  }
};

struct Errors {
  double velocity, tilt, rate, speed;  // root mean squares; the last of the motion
  unsigned restarts;
};
/// From 2 s to 20 s.
template <class Real>
Errors follow(double noise, bool feet = true) {
  using Io = ObserverIo<Real, WalkerConfig, 12, 4, eagerx::Rate<200>>;
  FloatingBaseObserver<Io> node;
  node.reset({});
  Walking walking;
  Sampler sample;
  const std::array<double, 3> bias = {0.03, -0.02, 0.025};
  Errors sum{};
  int count = 0;
  for (int n = 0; n < 4000; ++n) {
    auto& simulator = walking.simulator;
    Twelve q{}, v{};
    for (std::size_t j = 0; j < 12; ++j) {
      q[j] = simulator.joint_position(j) + noise * sample(0.005);
      v[j] = simulator.joint_velocity(j) + noise * sample(0.3);
    }
    PerFoot contacts{};
    for (std::size_t g = 0; g < 4; ++g)
      contacts[g] = feet && simulator.contact_force(g)[2] > 5.0 ? 1.0 : 0.0;
    std::array<double, 6> imu{};
    const auto exact = simulator.imu(0);
    for (std::size_t i = 0; i < 3; ++i) {
      imu[i] = exact[i] + noise * sample(0.5);
      imu[3 + i] = exact[3 + i] + noise * (bias[i] + sample(0.02));
    }
    const Outputs y = tick(node, q, v, contacts, imu);
    const RigidState truth = simulator.state(0);
    if (n >= 400) {
      const Quaternion back = inverse(truth.rotation);
      const Vector3 velocity = rotate(back, truth.velocity);
      const Vector3 gravity = rotate(back, {{0.0, 0.0, -1.0}});
      for (std::size_t i = 0; i < 3; ++i) {
        sum.velocity += std::pow(y.velocity[i] - velocity[i], 2);
        sum.tilt += std::pow(y.gravity[i] - gravity[i], 2);
        sum.rate += std::pow(y.angular_velocity[i] - exact[3 + i], 2);
        sum.speed += std::pow(velocity[i], 2);
      }
      ++count;
    }
    walking.tick();
  }
  const auto root = [&](double x) { return std::sqrt(x / count); };
  return {root(sum.velocity), root(sum.tilt), root(sum.rate), root(sum.speed), counts(node)[0]};
}

TEST(FloatingBase, FollowsAWalkerThatTrotsAndIsPushed) {
  const Errors exact = follow<double>(0.0), noisy = follow<double>(1.0),
               in_float = follow<float>(1.0), alone = follow<double>(1.0, false);
  const auto print = [](const char* what, const Errors& e) {
    std::printf("%s: %.4f m/s, %.4f rad, %.4f rad/s of %.2f m/s\n", what, e.velocity, e.tilt,
                e.rate, e.speed);
  };
  print("exact sensors", exact);
  print("noise and bias", noisy);
  print("in float", in_float);
  print("without feet", alone);
  EXPECT_GT(exact.speed, 0.1) << "it moves";
  EXPECT_LT(exact.velocity, 0.015);
  EXPECT_LT(exact.tilt, 0.003);
  EXPECT_LT(noisy.velocity, 0.02);
  EXPECT_LT(noisy.tilt, 0.006);
  EXPECT_LT(noisy.rate, 0.03) << "of 0.044 rad/s of bias, and noise of 0.02 rad/s";
  EXPECT_NEAR(in_float.velocity, noisy.velocity, 1e-3);
  EXPECT_GT(alone.velocity, 1.0) << "what the feet are for";
  for (const Errors& e : {exact, noisy, in_float}) EXPECT_EQ(e.restarts, 0U);
}

TEST(FloatingBase, LanesHaveTheBitsOfPlainNumbers) {
  using P = Simd<float, 4>;
  using Wide = ObserverIo<P, ObserverConfig<TwoLegs<P>>, 2, 2>;
  using Plain = ObserverIo<float, ObserverConfig<TwoLegs<float>>, 2, 2>;
  FloatingBaseObserver<Wide> vectorized;
  std::array<FloatingBaseObserver<Plain>, 4> plain;
  vectorized.reset({});
  for (auto& node : plain) node.reset({});
  Sampler sample;
  for (int n = 0; n < 300; ++n) {
    Array<P, 2> q{}, v{}, contacts{};
    Array<P, 6> imu{};
    Array<float, 2> q1[4], v1[4], contacts1[4];
    Array<float, 6> imu1[4];
    for (int l = 0; l < 4; ++l) {
      const auto set = [&](auto& wide, auto& one, std::size_t i, double x) {
        one[l][i] = static_cast<float>(x);
        set_lane(wide[i], l, one[l][i]);
      };
      for (std::size_t i = 0; i < 2; ++i) {
        set(q, q1, i, sample(0.3));
        set(v, v1, i, sample(1.0));
        set(contacts, contacts1, i, sample(1.0) > -0.6 ? 1.0 : 0.0);
      }
      const bool is_lost = sample(1.0) > 0.95;
      for (std::size_t i = 0; i < 6; ++i)
        set(imu, imu1, i, is_lost ? kNan<double> : (i == 2 ? kG : 0.0) + sample(0.5));
    }
    Array<P, 4> attitude{};
    Array<P, 3> velocity{}, rate{}, gravity{};
    typename Wide::Outputs out{attitude, velocity, rate, gravity};
    vectorized.callback({0}, {window(q), window(v), window(contacts), window(imu)}, out);
    for (int l = 0; l < 4; ++l) {
      Array<float, 4> attitude1{};
      Array<float, 3> velocity1{}, rate1{}, gravity1{};
      typename Plain::Outputs out1{attitude1, velocity1, rate1, gravity1};
      plain[static_cast<std::size_t>(l)].callback(
          {0}, {window(q1[l]), window(v1[l]), window(contacts1[l]), window(imu1[l])}, out1);
      for (std::size_t i = 0; i < 4; ++i) ASSERT_EQ(lane(attitude[i], l), attitude1[i]) << n;
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(lane(velocity[i], l), velocity1[i]) << n;
        ASSERT_EQ(lane(rate[i], l), rate1[i]) << n;
        ASSERT_EQ(lane(gravity[i], l), gravity1[i]) << n;
      }
    }
  }
}

}  // namespace
}  // namespace eagerx::models::testing::robots

// Blocks that know a robot: against Lagrange's equations, against the engine, and against each
// other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <models/nodes/computed_torque/computed_torque.hpp>
#include <models/nodes/forward_kinematics/forward_kinematics.hpp>
#include <models/nodes/gravity_compensation/gravity_compensation.hpp>
#include <models/nodes/inverse_dynamics/inverse_dynamics.hpp>
#include <models/nodes/inverse_kinematics/inverse_kinematics.hpp>
#include <models/nodes/jacobian/jacobian.hpp>
#include <models/nodes/operational_space/operational_space.hpp>
#include <models/objects/two_link_arm/two_link_arm.hpp>

#include "tests/unit/models/block_harness.hpp"
#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/multibody/robot_block_io.hpp"
#include "tests/unit/multibody/robots.hpp"
#include "tests/unit/multibody/sampler.hpp"

namespace eagerx::models::testing::robots {
namespace {

using blocks::kNan;
using blocks::window;

/// One tick of a node.
template <template <class> class Node, class Io, class Output, class... Message>
Output tick(Node<Io>& node, const Message&... message) {
  Output y{};
  typename Io::Outputs out{y};
  node.callback({0}, {window(message)...}, out);
  return y;
}
template <class Real, std::size_t N>
Array<Real, N> samples(Sampler& sample, double most) {
  Array<Real, N> x{};
  for (auto& element : x) element = static_cast<Real>(sample(most));
  return x;
}

// ---- against the two-link arm's equations
template <class Real>
using ArmOf = TwoLinkArm<ModelIo<Real, LagrangeArm::Config>>;
template <class Real>
struct ArmBlockConfig : RobotConfig<ArmOf<Real>> {
  static constexpr const char* body = "lower_arm";
  static constexpr std::array<double, 3> point = {0.0, 0.0, 0.2};  // the hand
};

template <class Real>
double worst_torque_of_arm() {
  using Io = DynamicsIo<Real, ArmBlockConfig<Real>, 2>;
  InverseDynamics<Io> node;
  Sampler sample;
  double worst = 0.0;
  for (int n = 0; n < 1000; ++n) {
    const std::array<double, 4> x = {sample(3), sample(3), sample(5), sample(5)};
    const double t[2] = {sample(10), sample(10)};
    const auto a = LagrangeArm::acceleration(x, t[0], t[1]);
    const auto number = [](double y) { return static_cast<Real>(y); };
    const Array<Real, 2> q{{number(x[0]), number(x[1])}}, v{{number(x[2]), number(x[3])}};
    const auto u = tick<InverseDynamics, Io, Array<Real, 2>>(
        node, q, v, Array<Real, 2>{{number(a[0]), number(a[1])}});
    for (std::size_t i = 0; i < 2; ++i)
      worst = std::max(worst, std::abs(static_cast<double>(u[i]) - t[i]) / 10.0);
  }
  return worst;
}
TEST(RobotBlocks, TorquesOfTheArmAreLagranges) {
  const double in_double = worst_torque_of_arm<double>(), in_float = worst_torque_of_arm<float>();
  std::printf("arm: torques %.1e in double, %.1e in float\n", in_double, in_float);
  EXPECT_LT(in_double, 1e-13);
  EXPECT_LT(in_float, 1e-4);
}
TEST(RobotBlocks, GravityOfTheArmIsThatOfTwoRods) {
  using Arm = LagrangeArm;
  using Io = GravityIo<double, ArmBlockConfig<double>, 2>;
  GravityCompensation<Io> node;
  const Array<double, 2> q{{0.7, -1.1}};
  const auto u = tick<GravityCompensation, Io, Array<double, 2>>(node, q);
  const double elbow = -Arm::m2 * Arm::g * Arm::c2 * std::sin(q[0] + q[1]);
  EXPECT_NEAR(u[1], elbow, 1e-13);
  EXPECT_NEAR(u[0], elbow - (Arm::m1 * Arm::c1 + Arm::m2 * Arm::l1) * Arm::g * std::sin(q[0]),
              1e-13);
}
TEST(RobotBlocks, HandOfTheArmIsWhereTwoRodsEnd) {
  using Io = ForwardIo<double, ArmBlockConfig<double>, 2>;
  ForwardKinematics<Io> node;
  const Array<double, 2> q{{0.7, -1.9}};
  const auto pose = tick<ForwardKinematics, Io, Array<double, 7>>(node, q);
  EXPECT_NEAR(pose[0], 0.5 * std::sin(0.7) + 0.4 * std::sin(-1.2), 1e-15);
  EXPECT_NEAR(pose[1], 0.0, 1e-15);
  EXPECT_NEAR(pose[2], 0.5 * std::cos(0.7) + 0.4 * std::cos(-1.2), 1e-15);
  EXPECT_NEAR(pose[3], std::cos(0.6), 1e-15);
  EXPECT_NEAR(pose[5], -std::sin(0.6), 1e-15) << "about y";
}

// ---- against the engine, of an arm with turned axes, a slider and a mimic
constexpr std::size_t kN = 4;
using Four = Array<double, kN>;
using Mixed = MixedArm<double>;
constexpr std::array<std::size_t, kN> kMixedJoints = {1, 2, 3, 4};

/// The accelerations of the joints, from the engine.
Four engine_accelerations(const Four& q, const Four& v, const Four& u) {
  MultibodyScene<Mixed> scene;
  for (std::size_t i = 0; i < kN; ++i) {
    scene.simulator.want_joint(kMixedJoints[i], {{q[i], 0.0}, {v[i], 0.0}});
    scene.simulator.set_joint_torque(kMixedJoints[i], u[i]);
  }
  scene.reset();
  const auto a = accelerations(scene.simulator);
  return {{-a[0], a[1], a[2], a[3]}};  // "turn" is about -z
}

template <std::size_t N>
void expect_near(const Array<double, N>& found, const Array<double, N>& expected, double relative) {
  double scale = 1.0;
  for (const double x : expected) scale = std::max(scale, std::abs(x));
  for (std::size_t i = 0; i < N; ++i) EXPECT_NEAR(found[i], expected[i], relative * scale) << i;
}

TEST(RobotBlocks, TheEngineAcceleratesAsInverseDynamicsWants) {
  using Io = DynamicsIo<double, MixedConfig<Mixed>, kN>;
  InverseDynamics<Io> node;
  Sampler sample;
  for (int n = 0; n < 200; ++n) {
    const Four q = samples<double, kN>(sample, 2), v = samples<double, kN>(sample, 3);
    const Four a = samples<double, kN>(sample, 20);
    const auto u = tick<InverseDynamics, Io, Four>(node, q, v, a);
    expect_near(engine_accelerations(q, v, u), a, 1e-10);
  }
}

TEST(RobotBlocks, TheEngineAcceleratesAsComputedTorqueWants) {
  using Config = MixedConfig<Mixed>;
  using Io = ComputedIo<double, Config, kN>;
  ComputedTorque<Io> node;
  Sampler sample;
  for (int n = 0; n < 50; ++n) {
    const Four q = samples<double, kN>(sample, 2), v = samples<double, kN>(sample, 3);
    const Four goal = samples<double, kN>(sample, 2), goal_v = samples<double, kN>(sample, 3);
    const Four goal_a = samples<double, kN>(sample, 20);
    const auto u = tick<ComputedTorque, Io, Four>(node, q, v, goal, goal_v, goal_a);
    Four a{};
    for (std::size_t i = 0; i < kN; ++i)
      a[i] = goal_a[i] + 20.0 * (goal_v[i] - v[i]) + Config::kp[i] * (goal[i] - q[i]);
    expect_near(engine_accelerations(q, v, u), a, 1e-10);
  }
}

/// A joint's damping takes damping·v more.
struct DampedArm : Mixed {
  static constexpr auto kJoints = [] {
    auto joints = Mixed::kJoints;
    joints[1].damping = 0.7;
    joints[3].damping = 30.0;
    return joints;
  }();
};
TEST(RobotBlocks, DampingOfJointsTakesTorque) {
  using Io = DynamicsIo<double, MixedConfig<Mixed>, kN>;
  using DampedIo = DynamicsIo<double, MixedConfig<DampedArm>, kN>;
  InverseDynamics<Io> node;
  InverseDynamics<DampedIo> damped;
  const Four q{{0.1, 0.2, 0.3, 0.4}}, v{{1.0, 2.0, -3.0, 4.0}}, a{};
  const auto u = tick<InverseDynamics, Io, Four>(node, q, v, a);
  const auto more = tick<InverseDynamics, DampedIo, Four>(damped, q, v, a);
  expect_near(more, {{u[0] + 0.7, u[1], u[2] - 90.0, u[3]}}, 1e-13);
}

Array<double, 7> pose_of(const Four& q) {
  using Io = ForwardIo<double, MixedConfig<Mixed>, kN>;
  ForwardKinematics<Io> node;
  return tick<ForwardKinematics, Io, Array<double, 7>>(node, q);
}
/// [row][joint]
std::array<Four, 6> jacobian_of(const Four& q) {
  using Io = JacobianIo<double, MixedConfig<Mixed>, kN>;
  Jacobian<Io> node;
  const auto matrix = tick<Jacobian, Io, Array<double, 6, kN>>(node, q);
  std::array<Four, 6> rows{};
  for (std::size_t i = 0; i < 6 * kN; ++i) rows[i / kN][i % kN] = element(matrix, i);
  return rows;
}
Four moved(Four q, const Four& v, double dt) {
  for (std::size_t i = 0; i < kN; ++i) q[i] += dt * v[i];
  return q;
}

TEST(RobotBlocks, ForwardKinematicsIsWhereTheEngineHasTheBody) {
  MultibodyScene<Mixed> scene;
  const Four q{{0.5, -0.7, 0.2, 1.1}};
  for (std::size_t i = 0; i < kN; ++i)
    scene.simulator.want_joint(kMixedJoints[i], {{q[i], 0.0}, {0.0, 0.0}});
  scene.reset();
  const auto body = scene.simulator.pose(4);
  const multibody::Turn<double> turn{body[3], body[4], body[5], body[6]};
  const auto p = multibody::rotated(turn, multibody::Vec<double>{0.01, 0.02, -0.03});
  expect_near(pose_of(q),
              {{body[0] + p.x, body[1] + p.y, body[2] + p.z, turn.w, turn.x, turn.y, turn.z}},
              1e-14);
}

TEST(RobotBlocks, JacobianIsTheSlopeOfForwardKinematics) {
  Sampler sample;
  for (int n = 0; n < 50; ++n) {
    const Four q = samples<double, kN>(sample, 2);
    const auto jacobian = jacobian_of(q);
    for (std::size_t i = 0; i < kN; ++i) {
      Four unit{};
      unit[i] = 1.0;
      const auto before = pose_of(moved(q, unit, -1e-6)), after = pose_of(moved(q, unit, 1e-6));
      const auto turned = multibody::rotation_between(
          multibody::Turn<double>{after[3], after[4], after[5], after[6]},
          multibody::Turn<double>{before[3], before[4], before[5], before[6]});
      const double turn[3] = {turned.x, turned.y, turned.z};
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(jacobian[k][i], (after[k] - before[k]) / 2e-6, 1e-8);
        EXPECT_NEAR(jacobian[3 + k][i], turn[k] / 2e-6, 1e-8);
      }
    }
  }
}

TEST(RobotBlocks, TheHandAcceleratesAsOperationalSpaceWants) {
  using Io = OperationalIo<double, HandConfig<Mixed>, kN, 3>;
  OperationalSpace<Io> node;
  Sampler sample;
  for (int n = 0; n < 50; ++n) {
    const Four q = samples<double, kN>(sample, 0.8), v = samples<double, kN>(sample, 2);
    const auto goal = samples<double, 3>(sample, 0.5), goal_v = samples<double, 3>(sample, 1);
    const auto goal_a = samples<double, 3>(sample, 5);
    const auto u = tick<OperationalSpace, Io, Four>(node, q, v, goal, goal_v, goal_a);
    const Four a = engine_accelerations(q, v, u);
    const auto pose = pose_of(q);
    const auto now = jacobian_of(q);
    const auto before = jacobian_of(moved(q, v, -1e-5)), after = jacobian_of(moved(q, v, 1e-5));
    Array<double, 3> found{}, wanted{};
    for (std::size_t i = 0; i < 3; ++i) {
      double speed = 0.0;
      for (std::size_t k = 0; k < kN; ++k) {
        speed += now[i][k] * v[k];
        found[i] += now[i][k] * a[k] + (after[i][k] - before[i][k]) / 2e-5 * v[k];
      }
      wanted[i] = goal_a[i] + 20.0 * (goal_v[i] - speed) + 100.0 * (goal[i] - pose[i]);
    }
    expect_near(found, wanted, 1e-7);
  }
}

// ---- inverse kinematics
template <std::size_t Goal, int Iterations>
struct SearchConfig : MixedConfig<Mixed> {
  static constexpr int iterations = Iterations;
  static constexpr double damping = 1e-6;
};
TEST(RobotBlocks, InverseKinematicsReachesPositions) {
  using Io = InverseIo<double, SearchConfig<3, 30>, kN, 3>;
  Sampler sample;
  int reached = 0;
  for (int n = 0; n < 100; ++n) {
    const auto pose = pose_of(samples<double, kN>(sample, 1.5));
    InverseKinematics<Io> node;
    node.reset({});
    const Four q =
        tick<InverseKinematics, Io, Four>(node, Array<double, 3>{{pose[0], pose[1], pose[2]}});
    const auto found = pose_of(q);
    const double error = std::hypot(found[0] - pose[0], found[1] - pose[1], found[2] - pose[2]);
    std::uint32_t misses = 9;
    node.for_each_count([&](const char* /*name*/, std::uint32_t count) { misses = count; });
    EXPECT_EQ(misses, error > 1e-3 ? 1U : 0U);
    reached += error < 1e-6 ? 1 : 0;
  }
  std::printf("inverse kinematics: %d of 100 positions within 1e-6 m after 30 iterations\n",
              reached);
  EXPECT_GE(reached, 98);
}
TEST(RobotBlocks, InverseKinematicsFollowsPoses) {
  using Io = InverseIo<double, SearchConfig<7, 2>, kN, 7>;
  InverseKinematics<Io> node;
  node.reset({});
  double worst = 0.0;
  for (int n = 0; n < 400; ++n) {
    const double t = 0.01 * n;
    const Four way{
        {0.1 + 0.5 * std::sin(t), 0.1 + 0.3 * t, 0.1 + 0.1 * std::sin(2 * t), 0.1 + 0.2 * t}};
    const Four q = tick<InverseKinematics, Io, Four>(node, pose_of(way));
    for (std::size_t i = 0; i < kN; ++i) worst = std::max(worst, std::abs(q[i] - way[i]));
  }
  EXPECT_LT(worst, 1e-3) << "two iterations a tick";
}
/// An elbow that bends one way.
struct OneWayArm : ArmOf<double> {
  static constexpr auto kJoints = [] {
    auto joints = ArmOf<double>::kJoints;
    joints[1].low = 0.2;
    joints[1].high = 2.5;
    return joints;
  }();
};
struct OneWayConfig : ArmBlockConfig<double> {
  struct model {
    using Model = OneWayArm;
  };
  static constexpr int iterations = 60;
};
TEST(RobotBlocks, InverseKinematicsKeepsWithinStops) {
  using Io = InverseIo<double, OneWayConfig, 2, 3>;
  InverseKinematics<Io> node;
  node.reset({});
  for (int n = 0; n < 20; ++n) {
    const double x = 0.9 * std::cos(0.3 * n), z = 0.9 * std::sin(0.3 * n);
    const auto q = tick<InverseKinematics, Io, Array<double, 2>>(node, Array<double, 3>{{x, 0, z}});
    EXPECT_GE(q[1], 0.2) << "0.9 m is as far as it reaches only when it is straight";
    EXPECT_LE(q[1], 2.5);
  }
  const auto q =
      tick<InverseKinematics, Io, Array<double, 2>>(node, Array<double, 3>{{0.3, 0.0, 0.4}});
  EXPECT_NEAR(0.5 * std::sin(q[0]) + 0.4 * std::sin(q[0] + q[1]), 0.3, 1e-6);
  EXPECT_NEAR(0.5 * std::cos(q[0]) + 0.4 * std::cos(q[0] + q[1]), 0.4, 1e-6);
}
TEST(RobotBlocks, InverseKinematicsStretchesTowardsWhatIsOutOfReach) {
  using Io = InverseIo<double, ArmBlockConfig<double>, 2, 3>;
  InverseKinematics<Io> node;
  node.reset({});
  Array<double, 2> q{};
  for (int n = 0; n < 20; ++n)
    q = tick<InverseKinematics, Io, Array<double, 2>>(node, Array<double, 3>{{2.0, 0.0, 0.0}});
  EXPECT_NEAR(q[0], std::acos(0.0), 1e-2) << "stretched towards the goal";
  EXPECT_NEAR(q[1], 0.0, 2e-2);
  const Array<double, 2> same = tick<InverseKinematics, Io, Array<double, 2>>(
      node, Array<double, 3>{{kNan<double>, 0.0, 0.0}});
  EXPECT_EQ(same, q);
}

// ---- what is not finite, limits, lanes
struct WeakArmConfig : ArmBlockConfig<float> {
  static constexpr std::array<double, 1> low = {-1.0};
  static constexpr std::array<double, 2> high = {2.0, -0.5};
};
TEST(RobotBlocks, TorquesStayWithinLimits) {
  using Io = GravityIo<float, WeakArmConfig, 2>;
  GravityCompensation<Io> node;
  using Two = Array<float, 2>;
  EXPECT_EQ((tick<GravityCompensation, Io, Two>(node, Two{{1.5F, 0.0F}})), (Two{{-1.0F, -1.0F}}));
  EXPECT_EQ((tick<GravityCompensation, Io, Two>(node, Two{{1.5F, kNan<float>}})),
            (Two{{0.0F, -0.5F}}));
}

/// A node of SIMD vectors and one of plain numbers for each lane give the same bits.
template <template <class> class Node, template <class> class IoOf, std::size_t M, std::size_t... N>
void expect_lanes_of() {
  using P = Simd<float, 4>;
  Node<IoOf<P>> vectorized;
  std::array<Node<IoOf<float>>, 4> plain;
  vectorized.reset({});
  for (auto& node : plain) node.reset({});
  Random random({7, 0, 0}, 1);
  for (int n = 0; n < 20; ++n) {
    std::tuple<Array<P, N>...> messages;
    std::tuple<Array<float, N>...> of_lane[4];
    const auto fill = [&](auto i) {
      auto& message = std::get<i>(messages);
      for (std::size_t k = 0; k < message.size(); ++k) {
        for (int l = 0; l < 4; ++l) {
          const float x = random.below(60) == 0 ? kNan<float> : random.uniform(-2.0F, 2.0F);
          set_lane(message[k], l, x);
          std::get<i>(of_lane[l])[k] = x;
        }
      }
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (fill(std::integral_constant<std::size_t, i>{}), ...);
    }
    (std::make_index_sequence<sizeof...(N)>{});
    const auto call = [](auto& node, const auto&... message) {
      using Io =
          std::conditional_t<std::is_same_v<decltype(node), Node<IoOf<P>>&>, IoOf<P>, IoOf<float>>;
      return tick<Node, Io, Array<typename Io::Real, M>>(node, message...);
    };
    const auto y = std::apply([&](auto&... m) { return call(vectorized, m...); }, messages);
    for (int l = 0; l < 4; ++l) {
      auto& node = plain[static_cast<std::size_t>(l)];
      const auto one = std::apply([&](auto&... m) { return call(node, m...); }, of_lane[l]);
      for (std::size_t i = 0; i < M; ++i) {
        const float found = lane(y[i], l);
        if (std::isnan(one[i]) && std::isnan(found)) continue;
        ASSERT_EQ(bits(found), bits(one[i])) << "tick " << n << " lane " << l << " of " << i;
      }
    }
  }
}
template <class Real>
using LaneDynamicsIo = DynamicsIo<Real, MixedConfig<MixedArm<Real>>, kN>;
template <class Real>
using LaneComputedIo = ComputedIo<Real, MixedConfig<MixedArm<Real>>, kN>;
template <class Real>
using LaneForwardIo = ForwardIo<Real, MixedConfig<MixedArm<Real>>, kN>;
template <class Real>
using LaneInverseIo = InverseIo<Real, MixedConfig<MixedArm<Real>>, kN, 7>;
template <class Real>
using LaneOperationalIo = OperationalIo<Real, HandConfig<MixedArm<Real>>, kN, 3>;
TEST(RobotBlocks, LanesHaveTheBitsOfPlainNumbers) {
  expect_lanes_of<InverseDynamics, LaneDynamicsIo, kN, kN, kN, kN>();
  expect_lanes_of<ComputedTorque, LaneComputedIo, kN, kN, kN, kN, kN, kN>();
  expect_lanes_of<ForwardKinematics, LaneForwardIo, 7, kN>();
  expect_lanes_of<InverseKinematics, LaneInverseIo, kN, 7>();
  expect_lanes_of<OperationalSpace, LaneOperationalIo, kN, kN, kN, 3, 3, 3>();
}

}  // namespace
}  // namespace eagerx::models::testing::robots

// Requests of engine nodes and engine states to the simulator; lanes of SIMD vectors.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <eagerx/simd.hpp>
#include <models/engine_states/body_center_of_mass/body_center_of_mass.hpp>
#include <models/engine_states/joint_gains/joint_gains.hpp>
#include <models/engine_states/joint_strength/joint_strength.hpp>
#include <models/objects/two_link_arm/two_link_arm.hpp>

#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/multibody/robots.hpp"

namespace eagerx::models::testing {
namespace {

struct RodsConfig {
  static constexpr std::array<double, 2> masses = {1.0, 1.0};
  static constexpr std::array<double, 2> lengths = {0.5, 0.5};
};

TEST(MultibodyNodes, MassAndForceMoveABody) {
  MultibodyScene<BoxOf<double>, WeightlessMultibody<20>> scene;
  scene.simulator.set_mass(0, 5.0);
  EXPECT_NEAR(scene.simulator.mass(0), 5.0, 1e-12);
  scene.simulator.want_pose(0, {{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0}});
  scene.simulator.set_force(0, {{0.0, 10.0, 0.0}});
  scene.reset();
  scene.run(1.0);
  EXPECT_NEAR(scene.simulator.twist(0)[1], 2.0, 1e-9);
  scene.simulator.set_force(0, {{0.0, 0.0, 0.0}});
  scene.run(1.0);
  EXPECT_NEAR(scene.simulator.twist(0)[1], 2.0, 1e-9);
}

TEST(MultibodyNodes, TheCentreOfMassMoves) {
  MultibodyScene<BoxOf<double>, WeightlessMultibody<20>> scene;
  scene.simulator.want_pose(0, {{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0}});
  scene.simulator.set_center_of_mass(0, {{0.0, 0.05, 0.0}});
  scene.simulator.set_force(0, {{10.0, 0.0, 0.0}});  // in the model's centre
  scene.reset();
  scene.tick();
  const double spin = 0.05 * 10.0 / BoxOf<double>::kBodies[0].inertia[2] * 0.02;
  EXPECT_NEAR(scene.simulator.twist(0)[5], spin, 1e-3 * spin);
  EXPECT_NEAR(scene.simulator.twist(0)[0] - 0.05 * spin, 10.0 / 2.0 * 0.02, 1e-3);
}

TEST(MultibodyNodes, StrengthAndGainsScaleActuators) {
  using Rods = MultibodyScene<TwoLinkArm<ModelIo<double, RodsConfig>>, WeightlessMultibody<20>>;
  const auto torques = [](double strength, double stiffness, double damping) {
    Rods scene;
    scene.simulator.set_strength(0, strength);
    scene.simulator.set_strength(1, strength);
    scene.simulator.set_gains(1, stiffness, damping);
    scene.simulator.set_joint_torque(0, 2.0);
    scene.simulator.want_joint(1, {{0.0, 0.0}, {10.0, 0.0}});
    scene.simulator.set_joint_servo(1, {1.0, 5.0, 0.01, 100.0});
    scene.reset();
    scene.simulator.step(
        {.stiffness = 0, .damping = 0, .slip_speed = 1, .correction = 0, .dt = 1e-6}, 1);
    return std::array<double, 2>{scene.simulator.joint_torque(0), scene.simulator.joint_torque(1)};
  };
  const auto plain = torques(1.0, 1.0, 1.0), weak = torques(0.5, 1.0, 1.0);
  EXPECT_NEAR(plain[0], 2.0, 1e-9);
  EXPECT_NEAR(plain[1], 4.9, 1e-3);  // 5·1 − 0.01·10
  EXPECT_NEAR(weak[0], 1.0, 1e-9);
  EXPECT_NEAR(weak[1], 2.45, 1e-3);
  EXPECT_NEAR(torques(1.0, 2.0, 1.0)[1], 9.9, 1e-3);
  EXPECT_NEAR(torques(1.0, 1.0, 20.0)[1], 3.0, 1e-3);
  EXPECT_EQ(torques(-1.0, std::nan(""), 1.0), plain);
}

TEST(MultibodyNodes, ForcesOnLinksActInTheirCentres) {
  MultibodyScene<FloatingWalker<double>, WeightlessMultibody<20>> scene;
  scene.simulator.want_pose(0, {{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0}});
  scene.simulator.set_force(5, {{0.0, 0.0, 3.0}});  // a thigh
  scene.reset();
  scene.run(0.1);
  double momentum = 0.0;
  for (std::size_t b = 0; b < 13; ++b)
    momentum += WalkerOf<double>::kBodies[b].mass * scene.simulator.twist(b)[2];
  EXPECT_NEAR(momentum, 0.3, 1e-3);
}

TEST(MultibodyNodes, AnImuAtRestFeelsTheGround) {
  MultibodyScene<BoxOf<double>> scene;
  const auto first = scene.simulator.imu(0);
  EXPECT_NEAR(first[2], 9.81, 1e-9);
  scene.run(0.5);
  const auto imu = scene.simulator.imu(0);
  EXPECT_NEAR(imu[2], 9.81, 1e-6);
  scene.simulator.want_pose(0, {{0.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0}});
  scene.reset();
  scene.run(0.2);
  EXPECT_NEAR(scene.simulator.imu(0)[2], 0.0, 1e-9);  // falls
}

TEST(MultibodyNodes, TheGravityOfOneObjectIsThatOfAll) {
  using Simulator = MultibodySimulator<BoxOf<double>>;
  Simulator one{}, other{};
  MultibodyEngine<EngineIo<double, MultibodyConfig<20>, eagerx::Rate<50>>> engine{};
  engine.start(one, other);
  one.set_gravity({{0.0, 0.0, -1.0}});
  engine.reset({}, one, other);
  EXPECT_EQ(other.numbers().gravity.z, -1.0);
  engine.reset({}, one, other);  // and it stays
  EXPECT_EQ(one.numbers().gravity.z, -1.0);
}

TEST(MultibodyNodes, AnEpisodeLeavesNothingToTheNext) {
  const auto play = [](auto& scene) {
    scene.simulator.want_pose(0, {{0.0, 0.0, 0.05, 1.0, 0.0, 0.0, 0.0}});
    scene.simulator.want_twist(0, {{1.0, 0.2, 0.0, 0.0, 0.0, 2.0}});
    scene.reset();
    scene.run(0.3);
    return scene.simulator.pose(0);
  };
  MultibodyScene<BoxOf<float>> scene;
  const auto first = play(scene), second = play(scene);
  EXPECT_EQ(first, second);
}

TEST(MultibodyNodes, BodiesAreWhereTheJointsPutThem) {
  MultibodyScene<WalkerOf<double>> scene;
  scene.simulator.want_pose(0, {{1.0, 2.0, 3.0, 1.0, 0.0, 0.0, 1.0}});  // a quarter turn about z
  scene.simulator.want_twist(0, {{0.0, 0.0, 0.0, 0.0, 0.0, 2.0}});
  scene.simulator.want_joint(1, {{0.5, 0.0}, {3.0, 0.0}});  // front left thigh
  scene.reset();
  using Model = WalkerOf<double>;
  const Vector3 centre = Model::kBodies[0].position, hip = Model::anchor(0, 1);
  const Vector3 thigh = Model::kBodies[2].position - hip;
  const Vector3 arm = rotate(rotation({{0.0, 1.0, 0.0}}, 0.5), thigh) + hip - centre;
  const Vector3 spin = rotate(rotation({{0.0, 1.0, 0.0}}, 0.5), Vector3{{0.0, 3.0, 0.0}});
  const Vector3 motion = cross(Vector3{{0.0, 0.0, 2.0}}, arm) + cross(spin, arm - (hip - centre));
  const RigidState at = scene.simulator.state(2);
  EXPECT_NEAR(at.position[0], 1.0 - arm[1], 1e-12);
  EXPECT_NEAR(at.position[1], 2.0 + arm[0], 1e-12);
  EXPECT_NEAR(at.position[2], 3.0 + arm[2], 1e-12);
  EXPECT_NEAR(at.velocity[0], -motion[1], 1e-12);
  EXPECT_NEAR(at.velocity[1], motion[0], 1e-12);
  EXPECT_NEAR(at.velocity[2], motion[2], 1e-12);
}

/// Four environments in the lanes of a SIMD vector: the bits of each alone.
TEST(MultibodySimd, LanesHaveTheBitsOfPlainNumbers) {
  constexpr std::size_t kLanes = 4;
  using Simd = eagerx::Simd<float, kLanes>;
  using One = MultibodySimulator<WalkerOf<float>>;
  using All = MultibodySimulator<WalkerOf<Simd>>;
  static_assert(sizeof(All) == kLanes * sizeof(One));
  std::array<One, kLanes> ones{};
  All all{};
  const auto lane_of = [](const auto& many, std::size_t lane, auto& one) {
    for (std::size_t word = 0; word < sizeof(One) / 4; ++word)
      std::memcpy(reinterpret_cast<char*>(&one) + 4 * word,
                  reinterpret_cast<const char*>(&many) + 4 * (word * kLanes + lane), 4);
  };
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    One& one = ones[lane];
    one.start({{0.1, 0.0, -9.81}});
    one.want_pose(0, {{0.0, 0.0, 0.25 + 0.02 * static_cast<double>(lane), 1.0, 0.05, 0.0, 0.0}});
    for (std::size_t j = 0; j < 12; ++j) {
      const auto offset = static_cast<float>((7 * lane + 3 * j) % 11) * 0.02F;
      const float home = j % 3 == 0 ? 0.0F : j % 3 == 1 ? 0.9F : -1.8F;
      one.want_joint(j, {{static_cast<double>(home), 0.0}, {0.0, 0.0}});
      one.set_joint_servo(j, {home + offset, 40.0F, 1.0F, 33.5F});
    }
    one.set_mass(0, 5.0 + static_cast<double>(lane));
    if (lane == 2) one.set_force(0, {{3.0F, 0.0F, 0.0F}});  // its lane alone is pushed
    one.begin_episode();
    for (std::size_t word = 0; word < sizeof(One) / 4; ++word)
      std::memcpy(reinterpret_cast<char*>(&all) + 4 * (word * kLanes + lane),
                  reinterpret_cast<const char*>(&one) + 4 * word, 4);
  }
  constexpr multibody::ContactSettings<float> kSettings{2e4F, 400.0F, 0.005F, 0.2F, 0.004F};
  for (int i = 0; i < 500; ++i) {
    all.step(kSettings, 4);
    for (One& one : ones) one.step(kSettings, 4);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    One from_simd{};
    lane_of(all, lane, from_simd);
    EXPECT_EQ(std::memcmp(&from_simd, &ones[lane], sizeof(One)), 0) << "lane " << lane;
    EXPECT_GT(ones[lane].pose(0)[2], 0.1F);
  }
}

}  // namespace
}  // namespace eagerx::models::testing

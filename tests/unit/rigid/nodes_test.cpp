// Engine nodes and engine states of OpenDynamicsEngine.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/rigid/nodes_io.hpp"

namespace eagerx::models::testing {
namespace {

using ArmScene = Scene<ArmModel, RigidConfig<20>>;
using BoxScene = Scene<BoxModel, RigidConfig<20>>;

/// The message that a sensor publishes now.
template <class Node, std::size_t N, class Simulator>
Array<float, N> sense(Simulator& simulator) {
  Array<float, N> observation{};
  const std::int64_t tick = 0;
  typename Node::Outputs out{observation};
  Node node;
  node.reset({}, simulator);
  node.callback({0}, {{&tick, 1, 1}}, out, simulator);
  return observation;
}

template <class Node, std::size_t N, class Simulator>
void act(Simulator& simulator, const Array<float, N>& action) {
  Array<float, N> applied{};
  const std::int64_t tick = 0;
  typename Node::Outputs out{applied};
  Node().callback({0}, {{&tick, 1, 1}, {&action, 1, 1}}, out, simulator);
  EXPECT_EQ(applied, action);
}

/// An entity with its Io's ports within reach.
template <template <class> class Entity, class IoType>
struct With : Entity<IoType> {
  using Outputs = typename IoType::Outputs;
};

TEST(RigidNodes, JointsInTheOrderOfTheirNames) {
  ArmScene scene;
  using Io = JointsIo<ArmScene::Simulator, 2>;
  JointState<RigidStateIo<Io, Array<float, 4>>>::reset({{0.5F, -0.25F, 1.5F, 2.5F}},
                                                       scene.simulator);
  scene.reset();
  const auto position = sense<With<JointPositionSensor, Io>, 2>(scene.simulator);
  const auto velocity = sense<With<JointVelocitySensor, Io>, 2>(scene.simulator);
  EXPECT_NEAR(position[0], 0.5F, 1e-6F);  // the elbow: the list begins with it
  EXPECT_NEAR(position[1], -0.25F, 1e-6F);
  EXPECT_NEAR(velocity[0], 1.5F, 1e-6F);
  EXPECT_NEAR(velocity[1], 2.5F, 1e-6F);
  EXPECT_NEAR(scene.simulator.joint_position(1), 0.5, 1e-7);
}

TEST(RigidNodes, StrengthAndGainsScaleActuators) {
  const auto torques = [](double strength, double stiffness) {
    ArmScene scene;
    scene.simulator.set_strength(0, strength);
    scene.simulator.set_gains(1, stiffness, 1.0);
    scene.simulator.set_joint_torque(0, 2.0);
    scene.simulator.set_joint_servo(1, {1e-3, 10.0, 0.0, 100.0});
    scene.simulator.before_step();
    return std::array<double, 2>{scene.simulator.joint_torque(0), scene.simulator.joint_torque(1)};
  };
  EXPECT_NEAR(torques(1.0, 1.0)[0], 2.0, 1e-12);
  EXPECT_NEAR(torques(0.5, 1.0)[0], 1.0, 1e-12);
  EXPECT_NEAR(torques(1.0, 3.0)[1], 0.03, 1e-12);
}

TEST(RigidNodes, PositionsAndVelocitiesOfJointsAreSetApart) {
  ArmScene scene;
  using Io = JointsIo<ArmScene::Simulator, 2>;
  using StateIo = RigidStateIo<Io, Array<float, 2>>;
  JointVelocities<StateIo>::reset({{1.5F, 2.5F}}, scene.simulator);
  JointPositions<StateIo>::reset({{0.5F, -0.25F}}, scene.simulator);
  scene.reset();
  EXPECT_NEAR(scene.simulator.joint_position(1), 0.5, 1e-6);  // the list begins with the elbow
  EXPECT_NEAR(scene.simulator.joint_position(0), -0.25, 1e-6);
  EXPECT_NEAR(scene.simulator.joint_velocity(1), 1.5, 1e-6);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 2.5, 1e-6);
  JointPositions<StateIo>::reset({{0.0F, 0.0F}}, scene.simulator);  // velocities stay
  scene.reset();
  EXPECT_NEAR(scene.simulator.joint_position(1), 0.0, 1e-6);
  EXPECT_NEAR(scene.simulator.joint_velocity(1), 1.5, 1e-6);
}

TEST(RigidNodes, TorquesAreSetAndSeen) {
  ArmScene scene;
  using Io = JointActionIo<ArmScene::Simulator, 2>;
  JointTorqueActuator<Io>().reset({}, scene.simulator);
  EXPECT_EQ(scene.simulator.joint_torque(1), 0.25);  // default_action
  act<With<JointTorqueActuator, Io>, 2>(scene.simulator, {{1.0F, -2.0F}});
  const auto seen =
      sense<With<JointTorqueSensor, JointsIo<ArmScene::Simulator, 2>>, 2>(scene.simulator);
  EXPECT_EQ(seen, (Array<float, 2>{{1.0F, -2.0F}}));
  EXPECT_EQ(scene.simulator.joint_torque(0), -2.0);
}

TEST(RigidNodes, MotorsHoldVelocitiesAndPositions) {
  ArmScene scene;
  using Io = JointActionIo<ArmScene::Simulator, 2>;
  act<With<JointMotorActuator, Io>, 2>(scene.simulator, {{0.5F, -0.5F}});
  for (int i = 0; i < 25; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(1), 0.5, 1e-3);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), -0.5, 1e-3);

  ArmScene other;
  act<With<JointPositionActuator, Io>, 2>(other.simulator, {{0.3F, 0.2F}});
  for (int i = 0; i < 250; ++i) other.tick();
  EXPECT_NEAR(other.simulator.joint_position(1), 0.3, 0.02);  // gravity pulls a little
  EXPECT_NEAR(other.simulator.joint_position(0), 0.2, 0.05);
}

TEST(RigidNodes, BodyStatesAndSensorsAgree) {
  BoxScene scene;
  using Io = BodyIo<BoxScene::Simulator, 7>;
  const Array<float, 7> pose{{1.0F, 2.0F, 3.0F, 0.8F, 0.0F, 0.6F, 0.0F}};
  const Array<float, 6> twist{{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F}};
  BodyPose<RigidStateIo<Io, Array<float, 7>>>::reset(pose, scene.simulator);
  BodyTwist<RigidStateIo<Io, Array<float, 6>>>::reset(twist, scene.simulator);
  scene.reset();
  const auto seen = sense<With<BodyPoseSensor, Io>, 7>(scene.simulator);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(seen[i], pose[i], 1e-6F);
  EXPECT_EQ((sense<With<BodyTwistSensor, BodyIo<BoxScene::Simulator, 6>>, 6>(scene.simulator)),
            twist);
}

TEST(RigidNodes, ImuFeelsNothingInFreeFallAndGravityAtRest) {
  BoxScene scene;
  using Io = BodyIo<BoxScene::Simulator, 6>;
  scene.simulator.want_pose(0, {{0.0, 0.0, 5.0, 0.8, 0.0, 0.6, 0.0}});
  scene.simulator.want_twist(0, {{0.0, 0.0, 0.0, 0.0, 2.0, 0.0}});
  scene.reset();
  auto imu = sense<With<ImuSensor, Io>, 6>(scene.simulator);
  EXPECT_NEAR(imu[0], -9.81F * 0.96F, 1e-4F);  // up, in the axes of the turned body
  EXPECT_NEAR(imu[2], 9.81F * 0.28F, 1e-4F);
  EXPECT_NEAR(imu[4], 2.0F, 1e-6F);
  for (int i = 0; i < 5; ++i) scene.tick();
  imu = sense<With<ImuSensor, Io>, 6>(scene.simulator);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(imu[i], 0.0F, 1e-4F);
}

TEST(RigidNodes, ForcesPushAndContactsPushBack) {
  BoxScene scene;
  using Contact = With<ContactForceSensor, GeometryIo<BoxScene::Simulator>>;
  sense<Contact, 3>(scene.simulator);  // its reset watches
  act<With<BodyForceActuator, ForceIo<BoxScene::Simulator>>, 3>(scene.simulator,
                                                                {{2.0F, 0.0F, -10.0F}});
  for (int i = 0; i < 50; ++i) scene.tick();
  const auto force = sense<Contact, 3>(scene.simulator);
  EXPECT_NEAR(force[0], -2.0F, 0.01F);
  EXPECT_NEAR(force[2], 2.0F * 9.81F + 10.0F, 0.01F);
}

TEST(RigidNodes, HeightsAndContactsAreThoseOfTheGround) {
  BoxScene scene;
  using Heights = With<HeightSensor, HeightsIo<BoxScene::Simulator, 2>>;
  using Contacts = With<ContactSensor, ContactsIo<BoxScene::Simulator>>;
  scene.simulator.want_pose(0, {{0.0, 0.0, 5.0, 0.8, 0.0, 0.6, 0.0}});  // 74 degrees, nose down
  scene.reset();
  const auto ends = sense<Heights, 2>(scene.simulator);
  EXPECT_NEAR(ends[0], 5.0F - 0.096F, 1e-6F);
  EXPECT_NEAR(ends[1], 5.0F + 0.096F, 1e-6F);
  scene.simulator.want_pose(0, {{0.0, 0.0, 0.05, 1.0, 0.0, 0.0, 0.0}});
  scene.reset();
  EXPECT_EQ((sense<Contacts, 2>(scene.simulator)), (Array<float, 2>{{0.0F, 0.0F}}));
  for (int i = 0; i < 50; ++i) scene.tick();
  EXPECT_EQ((sense<Contacts, 2>(scene.simulator)), (Array<float, 2>{{1.0F, 1.0F}})) << "19.6 N";
  EXPECT_NEAR((sense<With<HeightSensor, HeightsIo<BoxScene::Simulator, 1>>, 1>(scene.simulator)[0]),
              0.05F, 1e-3F);
}

TEST(RigidNodes, StatesChangeMassFrictionGravityAndParameters) {
  BoxScene scene;
  using Io = BodyIo<BoxScene::Simulator, 7>;
  BodyMass<RigidStateIo<Io, float>>::reset(3.0F, scene.simulator);
  EXPECT_NEAR(scene.simulator.mass(0), 3.0, 1e-6);
  GeometryFriction<RigidStateIo<GeometryIo<BoxScene::Simulator>, float>>::reset(0.0F,
                                                                                scene.simulator);
  Gravity<RigidStateIo<Io, Array<float, 3>>>::reset({{1.0F, 0.0F, -5.0F}}, scene.simulator);
  for (int i = 0; i < 50; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.state(0).velocity[0], 1.0, 1e-3);  // down a smooth slope
  Gravity<RigidStateIo<Io, float>>::reset(4.0F, scene.simulator);
  scene.simulator.watch_contact_force(0);
  for (int i = 0; i < 50; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.contact_force(0)[2], 12.0, 0.01);

  using PendulumScene = Scene<PendulumBodies<PendulumModelIo<double>>, RigidConfig<20>>;
  PendulumScene pendulum;
  ModelParameters<ParametersIo<PendulumScene::Simulator>>::reset({{0.05F, 0.04F}},
                                                                 pendulum.simulator);
  pendulum.reset();
  EXPECT_NEAR(pendulum.simulator.mass(0), 0.04, 1e-7);
  EXPECT_NEAR(pendulum.simulator.state(0).position[2], 0.05, 1e-7);
}

}  // namespace
}  // namespace eagerx::models::testing

// Io structs of blocks that know a robot, and an arm with every kind of joint.
#pragma once

#include <array>
#include <cstddef>
#include <models/engines/open_dynamics_engine/scene.hpp>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing::robots {

/// Three hinges, two of them on turned axes, a slider, and a finger that mimics another one. With
/// armatures, without damping and stops.
template <class RealType>
struct MixedArm {
  using Real = RealType;
  static constexpr Vector3 kOrigin{{0.1, -0.2, 0.3}};
  static constexpr std::array<RigidBody, 6> kBodies = {
      {{.name = "base", .mass = 2.0, .position = {{0.0, 0.0, 0.05}}},
       {.name = "column",
        .mass = 1.5,
        .inertia = {{0.012, 0.011, 0.004}},
        .position = {{0.01, 0.02, 0.2}},
        .products = {{0.001, -0.0005, 0.0007}}},
       {.name = "upper",
        .mass = 1.1,
        .inertia = {{0.009, 0.01, 0.003}},
        .position = {{0.1, -0.01, 0.45}},
        .products = {{-0.0004, 0.0003, 0.0002}}},
       {.name = "lower",
        .mass = 0.7,
        .inertia = {{0.003, 0.004, 0.002}},
        .position = {{0.3, 0.02, 0.5}}},
       {.name = "left",
        .mass = 0.1,
        .inertia = {{1e-3, 2e-3, 1e-3}},
        .position = {{0.5, 0.05, 0.5}}},
       {.name = "right",
        .mass = 0.12,
        .inertia = {{1e-3, 2e-3, 1e-3}},
        .position = {{0.5, -0.05, 0.5}}}}};
  static constexpr std::array<RigidJoint, 6> kJoints = {
      {{.name = "stand", .kind = JointKind::fixed, .child = "base"},
       {.name = "turn",
        .parent = "base",
        .child = "column",
        .anchor = {{0.0, 0.0, 0.1}},
        .axis = {{0.0, 0.0, -1.0}},
        .armature = 0.01},
       {.name = "lift",
        .parent = "column",
        .child = "upper",
        .anchor = {{0.02, 0.03, 0.4}},
        .axis = {{0.48, 0.6, 0.64}},
        .armature = 0.02},
       {.name = "push",
        .kind = JointKind::slider,
        .parent = "upper",
        .child = "lower",
        .anchor = {{0.2, 0.0, 0.5}},
        .axis = {{0.6, 0.0, -0.8}},
        .armature = 0.3},
       {.name = "grip",
        .parent = "lower",
        .child = "left",
        .anchor = {{0.4, 0.05, 0.5}},
        .axis = {{0.0, 0.6, 0.8}},
        .armature = 0.001},
       {.name = "follower",
        .parent = "lower",
        .child = "right",
        .anchor = {{0.4, -0.05, 0.5}},
        .axis = {{0.0, 1.0, 0.0}},
        .mimics = "grip",
        .ratio = -0.5,
        .offset = 0.1}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

/// A trunk on two legs with a hinge each, whose feet are spheres.
template <class RealType>
struct TwoLegs {
  using Real = RealType;
  static constexpr std::array<RigidBody, 3> kBodies = {
      {{.name = "trunk", .mass = 5.0, .inertia = {{0.05, 0.05, 0.05}}, .position = {{0, 0, 0.6}}},
       {.name = "left",
        .mass = 0.5,
        .inertia = {{0.01, 0.01, 0.001}},
        .position = {{0.15, 0.1, 0.4}}},
       {.name = "right",
        .mass = 0.5,
        .inertia = {{0.01, 0.01, 0.001}},
        .position = {{-0.15, -0.1, 0.4}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {{{.name = "left_hip",
                                                          .parent = "trunk",
                                                          .child = "left",
                                                          .anchor = {{0.15, 0.1, 0.6}},
                                                          .axis = {{0.0, 1.0, 0.0}}},
                                                         {.name = "right_hip",
                                                          .parent = "trunk",
                                                          .child = "right",
                                                          .anchor = {{-0.15, -0.1, 0.6}},
                                                          .axis = {{0.0, 0.8, 0.6}}}}};
  static constexpr std::array<RigidGeometry, 3> kGeometries = {
      {{.name = "left_foot",
        .body = "left",
        .size = {{0.03, 0.0, 0.0}},
        .position = {{0.0, 0.0, -0.4}}},
       {.name = "right_foot",
        .body = "right",
        .size = {{0.02, 0.0, 0.0}},
        .position = {{0.0, 0.0, -0.4}}},
       {.name = "ground", .kind = ShapeKind::plane}}};
};

/// Defaults of the manifests, for all joints of a model.
template <class ModelType>
struct RobotConfig {
  struct model {
    using Model = ModelType;
  };
  static constexpr const char* joints = "";
  static constexpr std::array<double, 3> gravity = {0.0, 0.0, -9.81};
  static constexpr std::array<double, 1> low = {-1e6};
  static constexpr std::array<double, 1> high = {1e6};
  static constexpr std::array<double, 3> point = {0.01, 0.02, -0.03};
  static constexpr double regularization = 0.0;
  static constexpr std::array<double, 1> posture = {0.2};
  static constexpr double posture_kp = 9.0, posture_kd = 6.0;
  static constexpr std::array<double, 1> initial = {0.1};
  static constexpr int iterations = 10;
  static constexpr double damping = 1e-4, lever = 0.2, tolerance = 1e-3;
};
template <class Model>
struct MixedConfig : RobotConfig<Model> {
  static constexpr const char* body = "left";
  static constexpr std::array<double, 4> kp = {100.0, 80.0, 60.0, 50.0};
  static constexpr std::array<double, 1> kd = {20.0};
};
/// OperationalSpace has one gain for all directions.
template <class Model>
struct HandConfig : MixedConfig<Model> {
  static constexpr double kp = 100.0, kd = 20.0;
};

/// FloatingBaseObserver.
template <class ModelType>
struct ObserverConfig {
  struct model {
    using Model = ModelType;
  };
  static constexpr const char* joints = "";
  static constexpr const char* feet = "left_foot right_foot";
  static constexpr double gravity = 9.81;
  static constexpr double gyro_noise = 0.02, accelerometer_noise = 0.5, bias_drift = 1e-3;
  static constexpr double foot_noise = 0.1, gate = 4.0, patience = 0.5;
  static constexpr double initial_tilt = 0.1, initial_speed = 1.0, initial_bias = 0.05;
};

template <class RealType, class ConfigType>
struct RobotIo {
  using Real = RealType;
  using Rate = eagerx::Rate<100>;
  using Config = ConfigType;
  using States = NoStates;
  template <std::size_t N>
  using In = Skipped<Array<Real, N>>;
};
template <class Real, class Config, std::size_t N>
struct DynamicsIo : RobotIo<Real, Config> {
  struct Inputs {
    Skipped<Array<Real, N>> q, v, a;
  };
  struct Outputs {
    Array<Real, N>& u;
  };
};
template <class Real, class Config, std::size_t N, std::size_t Feet, class RateType = Rate<100>>
struct ObserverIo : RobotIo<Real, Config> {
  using Rate = RateType;
  struct Inputs {
    Skipped<Array<Real, N>> q, v;
    Skipped<Array<Real, Feet>> contacts;
    Skipped<Array<Real, 6>> imu;
  };
  struct Outputs {
    Array<Real, 4>& attitude;
    Array<Real, 3>&velocity, &angular_velocity, &gravity;
  };
};
template <class Real, class Config, std::size_t N>
struct GravityIo : RobotIo<Real, Config> {
  struct Inputs {
    Skipped<Array<Real, N>> q;
  };
  struct Outputs {
    Array<Real, N>& u;
  };
};
template <class Real, class Config, std::size_t N>
struct ComputedIo : RobotIo<Real, Config> {
  struct Inputs {
    Skipped<Array<Real, N>> q, v, goal, goal_v, goal_a;
  };
  struct Outputs {
    Array<Real, N>& u;
  };
};
template <class Real, class Config, std::size_t N>
struct ForwardIo : RobotIo<Real, Config> {
  struct Inputs {
    Skipped<Array<Real, N>> q;
  };
  struct Outputs {
    Array<Real, 7>& pose;
  };
};
template <class Real, class Config, std::size_t N>
struct JacobianIo : RobotIo<Real, Config> {
  struct Inputs {
    Skipped<Array<Real, N>> q;
  };
  struct Outputs {
    Array<Real, 6, N>& matrix;
  };
};
template <class Real, class Config, std::size_t N, std::size_t Goal>
struct InverseIo : RobotIo<Real, Config> {
  struct Inputs {
    Skipped<Array<Real, Goal>> goal;
  };
  struct Outputs {
    Array<Real, N>& q;
  };
};
template <class Real, class Config, std::size_t N, std::size_t Goal>
struct PosturedInverseIo : RobotIo<Real, Config> {
  struct Inputs {
    Skipped<Array<Real, Goal>> goal;
    Skipped<Array<Real, N>> start;
  };
  struct Outputs {
    Array<Real, N>& q;
  };
};
template <class Real, class Config, std::size_t N, std::size_t Goal>
struct OperationalIo : RobotIo<Real, Config> {
  static constexpr std::size_t kRows = Goal == 3 ? 3 : 6;
  struct Inputs {
    Skipped<Array<Real, N>> q, v;
    Skipped<Array<Real, Goal>> goal;
    Skipped<Array<Real, kRows>> goal_v, goal_a;
  };
  struct Outputs {
    Array<Real, N>& u;
  };
};

}  // namespace eagerx::models::testing::robots

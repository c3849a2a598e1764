// Io structs of the engine nodes and engine states of OpenDynamicsEngine, as the generator emits
// them.
#pragma once

#include <models/engine_nodes/body_force_actuator/body_force_actuator.hpp>
#include <models/engine_nodes/body_pose_sensor/body_pose_sensor.hpp>
#include <models/engine_nodes/body_twist_sensor/body_twist_sensor.hpp>
#include <models/engine_nodes/contact_force_sensor/contact_force_sensor.hpp>
#include <models/engine_nodes/contact_sensor/contact_sensor.hpp>
#include <models/engine_nodes/height_sensor/height_sensor.hpp>
#include <models/engine_nodes/imu_sensor/imu_sensor.hpp>
#include <models/engine_nodes/joint_motor_actuator/joint_motor_actuator.hpp>
#include <models/engine_nodes/joint_position_actuator/joint_position_actuator.hpp>
#include <models/engine_nodes/joint_position_sensor/joint_position_sensor.hpp>
#include <models/engine_nodes/joint_torque_actuator/joint_torque_actuator.hpp>
#include <models/engine_nodes/joint_torque_sensor/joint_torque_sensor.hpp>
#include <models/engine_nodes/joint_velocity_sensor/joint_velocity_sensor.hpp>
#include <models/engine_nodes/model_input/model_input.hpp>
#include <models/engine_states/body_mass/body_mass.hpp>
#include <models/engine_states/body_pose/body_pose.hpp>
#include <models/engine_states/body_twist/body_twist.hpp>
#include <models/engine_states/geometry_friction/geometry_friction.hpp>
#include <models/engine_states/gravity/gravity.hpp>
#include <models/engine_states/joint_positions/joint_positions.hpp>
#include <models/engine_states/joint_state/joint_state.hpp>
#include <models/engine_states/joint_velocities/joint_velocities.hpp>
#include <models/engine_states/model_parameters/model_parameters.hpp>
#include <models/objects/pendulum/pendulum_bodies.hpp>
#include <models/objects/pushed_box/pushed_box.hpp>
#include <models/objects/two_link_arm/two_link_arm.hpp>

#include "tests/unit/rigid/rigid_io.hpp"

namespace eagerx::models::testing {

struct TwoRodsIo {
  using Real = double;
  struct Config {
    static constexpr std::array<double, 2> masses = {1.0, 1.0};
    static constexpr std::array<double, 2> lengths = {0.5, 0.5};
  };
};
using ArmModel = TwoLinkArm<TwoRodsIo>;

struct SmallBoxIo {
  using Real = double;
  struct Config {
    static constexpr double mass = 2.0;
    static constexpr std::array<double, 3> size = {0.2, 0.2, 0.1};
    static constexpr double friction = 0.5;
    static constexpr double bounce = 0.0;
  };
};
using BoxModel = PushedBox<SmallBoxIo>;

template <class SimulatorType, std::size_t N>
struct SensorIo {
  using Real = double;
  using Simulator = SimulatorType;
  using States = NoStates;
  struct Inputs {
    Latest<std::int64_t> tick;
  };
  struct Outputs {
    Array<float, N>& observation;
  };
};
template <class Simulator, std::size_t N>
struct JointsIo : SensorIo<Simulator, N> {
  struct Config {
    static constexpr const char* joints = "elbow shoulder";
  };
};
template <class Simulator, std::size_t N>
struct BodyIo : SensorIo<Simulator, N> {
  struct Config {
    static constexpr const char* body = "box";
  };
};
template <class Simulator>
struct GeometryIo : SensorIo<Simulator, 3> {
  struct Config {
    static constexpr const char* geometry = "box";
  };
};

/// Of the box's ends along x, or of its center.
template <class Simulator, std::size_t N>
struct HeightsIo : SensorIo<Simulator, N> {
  struct Config {
    static constexpr const char* bodies = N == 2 ? "box box" : "box";
    static constexpr std::array<double, 3 * N> points = [] {
      std::array<double, 3 * N> all{};
      if constexpr (N == 2) all = {0.1, 0.0, 0.0, -0.1, 0.0, 0.0};
      return all;
    }();
  };
};
template <class Simulator>
struct ContactsIo : SensorIo<Simulator, 2> {
  struct Config {
    static constexpr const char* geometries = "ground box";
    static constexpr double threshold = 19.0;
  };
};

template <class SimulatorType, std::size_t N>
struct ActuatorIo {
  using Real = double;
  using Simulator = SimulatorType;
  using States = NoStates;
  struct Inputs {
    Latest<std::int64_t> tick;
    Latest<Array<float, N>> action;
  };
  struct Outputs {
    Array<float, N>& action_applied;
  };
};
template <class Simulator, std::size_t N>
struct JointActionIo : ActuatorIo<Simulator, N> {
  struct Config {
    static constexpr const char* joints = "elbow shoulder";
    static constexpr std::array<double, 2> default_action = {0.25, 0.5};
    static constexpr double max_torque = 50.0;
    static constexpr double stiffness = 400.0;
    static constexpr double damping = 20.0;
  };
};
template <class Simulator>
struct ForceIo : ActuatorIo<Simulator, 3> {
  struct Config {
    static constexpr const char* body = "box";
    static constexpr std::array<double, 3> default_action = {0.0, 0.0, 0.0};
  };
};

/// An engine state with the configuration of a node's Io.
template <class NodeIoType, class StateType>
struct RigidStateIo {
  using Real = double;
  using Simulator = typename NodeIoType::Simulator;
  using State = StateType;
  using Config = typename NodeIoType::Config;
};

/// Length and mass of the pendulum.
template <class SimulatorType>
struct ParametersIo {
  using Real = double;
  using Simulator = SimulatorType;
  using State = Array<float, 2>;
  struct Config {
    static constexpr std::array<int, 2> indices = {2, 1};
  };
};

}  // namespace eagerx::models::testing

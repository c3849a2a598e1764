// Velocity motors of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engine_nodes/actuator.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>

namespace eagerx::models {

/// Velocity that the joint's motor holds [rad/s, m/s] := action, for each of `joints`.
template <class Io>
class JointMotorActuator : public Actuator<Io, JointMotorActuator<Io>> {
 public:
  using Simulator = typename Io::Simulator;

  template <class Message>
  static void apply(Simulator& simulator, const Message& action) {
    using Joints = JointList<typename Simulator::Model, typename Io::Config>;
    static_assert(Joints::has_only_hinges_and_sliders(),
                  "JointMotorActuator: `joints` must be hinges and sliders");
    static_assert(Joints::kCount == size_of<Message>,
                  "JointMotorActuator: the action must have one value for each joint");
    for (std::size_t i = 0; i < Joints::kCount; ++i) {
      const auto value = static_cast<double>(element(action, i));
      simulator.set_joint_motor(Joints::kJoints[i], value, Io::Config::max_torque);
    }
  }
};

}  // namespace eagerx::models

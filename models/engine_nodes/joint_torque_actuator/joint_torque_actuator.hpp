// Sets torques of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engine_nodes/actuator.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>

namespace eagerx::models {

/// Torque of a hinge [N·m] or force of a slider [N] := action, for each of `joints`.
template <class Io>
class JointTorqueActuator : public Actuator<Io, JointTorqueActuator<Io>> {
 public:
  using Simulator = typename Io::Simulator;

  template <class Message>
  static void apply(Simulator& simulator, const Message& action) {
    using Joints = JointList<typename Simulator::Model, typename Io::Config>;
    static_assert(Joints::has_only_hinges_and_sliders(),
                  "JointTorqueActuator: `joints` must be hinges and sliders");
    static_assert(Joints::kCount == size_of<Message>,
                  "JointTorqueActuator: the action must have one value for each joint");
    for (std::size_t i = 0; i < Joints::kCount; ++i) {
      const auto value = static_cast<double>(element(action, i));
      simulator.set_joint_torque(Joints::kJoints[i], value);
    }
  }
};

}  // namespace eagerx::models

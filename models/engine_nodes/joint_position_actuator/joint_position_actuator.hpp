// Position control of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engine_nodes/actuator.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>

namespace eagerx::models {

/// Position that the joint's servo turns to [rad, m] := action, for each of `joints`.
template <class Io>
class JointPositionActuator : public Actuator<Io, JointPositionActuator<Io>> {
 public:
  using Simulator = typename Io::Simulator;

  template <class Message>
  static void apply(Simulator& simulator, const Message& action) {
    using Joints = JointList<typename Simulator::Model, typename Io::Config>;
    static_assert(Joints::has_only_hinges_and_sliders(),
                  "JointPositionActuator: `joints` must be hinges and sliders");
    static_assert(Joints::kCount == size_of<Message>,
                  "JointPositionActuator: the action must have one value for each joint");
    for (std::size_t i = 0; i < Joints::kCount; ++i) {
      const auto value = static_cast<double>(element(action, i));
      simulator.set_joint_servo(Joints::kJoints[i], {.position = value,
                                                     .stiffness = Io::Config::stiffness,
                                                     .damping = Io::Config::damping,
                                                     .max_torque = Io::Config::max_torque});
    }
  }
};

}  // namespace eagerx::models

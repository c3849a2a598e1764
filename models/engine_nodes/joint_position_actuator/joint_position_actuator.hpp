// Position control of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Position that the joint's servo turns to [rad, m] := action, for each of `joints`.
template <class Io>
class JointPositionActuator : public JointActuator<Io, JointPositionActuator<Io>> {
 public:
  static void command(typename Io::Simulator& simulator, std::size_t joint, std::size_t place,
                      const typename Io::Simulator::Number& value) {
    using Simulator = typename Io::Simulator;
    simulator.set_joint_servo(joint, {.position = value,
                                      .stiffness = number_for<Simulator>(stiffness(place)),
                                      .damping = number_for<Simulator>(damping(place)),
                                      .max_torque = number_for<Simulator>(Config::max_torque)});
  }

 private:
  using Config = typename Io::Config;

  // Of the joint at this place in `joints`.
  static constexpr double stiffness(std::size_t place) {
    if constexpr (requires { Config::stiffnesses[0]; }) {
      if (place < Config::stiffnesses.size()) return Config::stiffnesses[place];
    }
    return Config::stiffness;
  }
  static constexpr double damping(std::size_t place) {
    if constexpr (requires { Config::dampings[0]; }) {
      if (place < Config::dampings.size()) return Config::dampings[place];
    }
    return Config::damping;
  }
};

}  // namespace eagerx::models

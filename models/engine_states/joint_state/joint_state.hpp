// Sets positions and velocities of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>

namespace eagerx::models {

/// At a reset: positions [n], then velocities [n], of the n positions that `joints` have.
template <class Io>
struct JointState {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Joints = JointList<typename Io::Simulator::Model, typename Io::Config>;
    constexpr auto kAxes = Joints::axes();
    static_assert(
        size_of<typename Io::State> == 2 * kAxes.size(),
        "JointState: the state has a position and a velocity for each number that the joints have");
    JointCoordinates at;
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const auto [joint, axis] = kAxes[i];
      at.position[axis] = static_cast<double>(element(value, i));
      at.velocity[axis] = static_cast<double>(element(value, kAxes.size() + i));
      simulator.want_joint(joint, at);  // complete with the joint's last axis
    }
  }
};

}  // namespace eagerx::models

// Sets the positions of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>

namespace eagerx::models {

/// At a reset: the positions [n] that `joints` have together.
template <class Io>
struct JointPositions {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Joints = JointList<typename Io::Simulator::Model, typename Io::Config>;
    constexpr auto kAxes = Joints::axes();
    static_assert(size_of<typename Io::State> == kAxes.size(),
                  "JointPositions: the state has a position for each number that the joints have");
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const auto [joint, axis] = kAxes[i];
      JointCoordinates at = simulator.next_joint(joint);
      at.position[axis] = static_cast<double>(element(value, i));
      simulator.want_joint(joint, at);
    }
  }
};

}  // namespace eagerx::models

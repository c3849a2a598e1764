// Torques that act on joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [size] := torque of each of `joints` in the last step [N·m, N].
template <class Io>
class JointTorqueSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    using Joints = JointList<typename Simulator::Model, typename Io::Config>;
    static_assert(Joints::has_only_hinges_and_sliders(),
                  "JointTorqueSensor: `joints` must be hinges and sliders");
    static_assert(Joints::kCount == size_of<Message>,
                  "JointTorqueSensor: `size` must be the number of joints");
    for (std::size_t i = 0; i < Joints::kCount; ++i) {
      element(out.observation, i) =
          static_cast<ScalarOf<Message>>(simulator.joint_torque(Joints::kJoints[i]));
    }
  }
};

}  // namespace eagerx::models

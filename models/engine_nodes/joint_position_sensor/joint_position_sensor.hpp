// Positions of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [size] := positions of `joints` [rad, m] at the time of the tick.
template <class Io>
class JointPositionSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Joints = JointList<typename Simulator::Model, typename Io::Config>;
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    static_assert(Joints::size() == size_of<Message>,
                  "JointPositionSensor: `size` must be how many numbers the joints have together");
    constexpr auto kAxes = Joints::axes();
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      element(out.observation, i) =
          static_cast<ScalarOf<Message>>(simulator.joint_position(kAxes[i].joint, kAxes[i].axis));
    }
  }
};

}  // namespace eagerx::models

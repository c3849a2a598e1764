// Sets the gains of servos.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>

namespace eagerx::models {

/// At a reset: factors on stiffness and damping of the servos of `joints` := value [2].
template <class Io>
struct JointGains {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Joints = JointList<typename Io::Simulator::Model, typename Io::Config>;
    static_assert(Joints::has_only_hinges_and_sliders(),
                  "JointGains: `joints` must be hinges and sliders");
    static_assert(size_of<typename Io::State> == 2, "JointGains: the state has two factors");
    for (const std::size_t joint : Joints::kJoints) {
      simulator.set_gains(joint, static_cast<double>(element(value, 0)),
                          static_cast<double>(element(value, 1)));
    }
  }
};

}  // namespace eagerx::models

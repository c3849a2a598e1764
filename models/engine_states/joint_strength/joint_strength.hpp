// Sets how strong the actuators of joints are.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>

namespace eagerx::models {

/// At a reset: factor on the torques of each of `joints` := value [n], or value [] for all.
template <class Io>
struct JointStrength {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Joints = JointList<typename Io::Simulator::Model, typename Io::Config>;
    constexpr std::size_t kSize = size_of<typename Io::State>;
    static_assert(Joints::has_only_hinges_and_sliders(),
                  "JointStrength: `joints` must be hinges and sliders");
    static_assert(kSize == Joints::kCount || kSize == 1,
                  "JointStrength: the state has a factor for each joint, or one for all");
    for (std::size_t i = 0; i < Joints::kCount; ++i) {
      const auto factor = static_cast<double>(element(value, kSize == 1 ? 0 : i));
      simulator.set_strength(Joints::kJoints[i], factor);
    }
  }
};

}  // namespace eagerx::models

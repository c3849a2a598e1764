// Joints that an engine node or engine state names in its configuration.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/rigid_joints.hpp>

namespace eagerx::models {

/// A position of a joint: universal joints have two.
struct JointAxis {
  std::size_t joint = 0;
  std::size_t axis = 0;
};

/// The joints that `Names` lists, as positions in the model's kJoints.
template <class Model, class Names>
struct JointList {
  static constexpr std::size_t kCount = scene::count_names(Names::joints);
  static constexpr auto kJoints = scene::find_all<kCount>(Model::kJoints, Names::joints);
  static constexpr bool kExist = scene::all_below(kJoints, Model::kJoints.size());
  static_assert(kExist, "`joints` names a joint that the object's model does not have");

  /// How many positions they have together.
  static constexpr std::size_t size() {
    std::size_t result = 0;
    for (const std::size_t joint : kJoints) {
      if (joint < Model::kJoints.size()) result += degrees_of_freedom(Model::kJoints[joint].kind);
    }
    return result;
  }
  static constexpr bool has_only_hinges_and_sliders() { return kExist && size() == kCount; }

  /// One for each position, in order.
  static constexpr std::array<JointAxis, size()> axes() {
    std::array<JointAxis, size()> result{};
    std::size_t i = 0;
    for (const std::size_t joint : kJoints) {
      if (joint >= Model::kJoints.size()) continue;
      for (std::size_t k = 0; k < degrees_of_freedom(Model::kJoints[joint].kind); ++k)
        result[i++] = {joint, k};
    }
    return result;
  }
};

}  // namespace eagerx::models

// Sets the pose of a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// At a reset: position [m] and quaternion [w, x, y, z] of a body without a joint to a parent.
template <class Io>
struct BodyPose {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Model = typename Io::Simulator::Model;
    constexpr std::size_t kItem = scene::find(Model::kBodies, Io::Config::body);
    static_assert(kItem < Model::kBodies.size(),
                  "BodyPose: `body` is not a body of the object's model");
    static_assert(size_of<typename Io::State> == 7,
                  "BodyPose: a pose is a position and a quaternion");
    static_assert(!scene::is_child<Model>(kItem),
                  "BodyPose: `body` hangs on a joint: use JointState");
    Pose pose{};
    for (std::size_t i = 0; i < 7; ++i) pose[i] = static_cast<double>(element(value, i));
    simulator.want_pose(kItem, pose);
  }
};

}  // namespace eagerx::models

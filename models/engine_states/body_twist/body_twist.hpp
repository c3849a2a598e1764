// Sets the velocities of a body simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// At a reset: velocity [m/s] and angular velocity [rad/s] of a body without a joint to a parent.
template <class Io>
struct BodyTwist {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Model = typename Io::Simulator::Model;
    constexpr std::size_t kItem = scene::find(Model::kBodies, Io::Config::body);
    static_assert(kItem < Model::kBodies.size(),
                  "BodyTwist: `body` is not a body of the object's model");
    static_assert(size_of<typename Io::State> == 6,
                  "BodyTwist: a twist is a velocity and an angular velocity");
    static_assert(!scene::is_child<Model>(kItem),
                  "BodyTwist: `body` hangs on a joint: use JointState");
    Twist twist{};
    for (std::size_t i = 0; i < 6; ++i) twist[i] = static_cast<double>(element(value, i));
    simulator.want_twist(kItem, twist);
  }
};

}  // namespace eagerx::models

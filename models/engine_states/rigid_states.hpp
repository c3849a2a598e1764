// Shared parts of states of joints and bodies on OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// At a reset: Derived::part(coordinates of a joint)[axis] := the numbers [n] that `joints` have
/// together.
template <class Io, class Derived>
struct JointNumbers {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Joints = JointList<typename Io::Simulator::Model, typename Io::Config>;
    constexpr auto kAxes = Joints::axes();
    static_assert(size_of<typename Io::State> == kAxes.size(),
                  "state of joints: it has a number for each that the joints have");
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const auto [joint, axis] = kAxes[i];
      JointCoordinates at = simulator.next_joint(joint);
      Derived::part(at)[axis] = static_cast<double>(element(value, i));
      simulator.want_joint(joint, at);
    }
  }
};

/// The body that `body` names, and its state as numbers.
template <class Io, std::size_t kSize>
struct BodyNumbers {
  using Model = typename Io::Simulator::Model;
  static constexpr std::size_t kBody = scene::find(Model::kBodies, Io::Config::body);
  static_assert(kBody < Model::kBodies.size(),
                "state of a body: `body` is not a body of the object's model");
  static_assert(size_of<typename Io::State> == kSize,
                "state of a body: a pose has 7 numbers, a twist 6, a mass 1");

  static Array<double, kSize> of(const typename Io::State& value) {
    Array<double, kSize> numbers{};
    for (std::size_t i = 0; i < kSize; ++i) numbers[i] = static_cast<double>(element(value, i));
    return numbers;
  }
};

/// Of a body without a joint to a parent.
template <class Io, std::size_t kSize>
struct FreeBodyNumbers : BodyNumbers<Io, kSize> {
  static_assert(!scene::is_child<typename Io::Simulator::Model>(BodyNumbers<Io, kSize>::kBody),
                "state of a body: `body` hangs on a joint: use JointState");
};

}  // namespace eagerx::models

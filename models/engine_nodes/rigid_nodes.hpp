// Shared parts of sensors and actuators of joints and bodies on OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/engine_nodes/actuator.hpp>
#include <models/engines/open_dynamics_engine/joint_list.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: Derived::sense(simulator, observation [n]).
template <class Io, class Derived>
class RigidSensor {
 public:
  using Simulator = typename Io::Simulator;
  using Model = typename Simulator::Model;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    Derived::sense(simulator, out.observation);
  }

 protected:
  /// element i of `to` := value.
  template <class Message, class Number>
  static void put(Message& to, std::size_t i, const Number& value) {
    element(to, i) = static_cast<ScalarOf<Message>>(value);
  }
};

/// Every tick: observation [size] := Derived::number(simulator, joint, axis) of each axis of
/// `joints` at the time of the tick.
template <class Io, class Derived>
class JointSensor : public RigidSensor<Io, JointSensor<Io, Derived>> {
 public:
  template <class Simulator, class Message>
  static void sense(const Simulator& simulator, Message& observation) {
    using Joints = JointList<typename Simulator::Model, typename Io::Config>;
    static_assert(Joints::size() == size_of<Message>,
                  "sensor of joints: `size` must be how many numbers the joints have together");
    constexpr auto kAxes = Joints::axes();
    for (std::size_t i = 0; i < kAxes.size(); ++i)
      JointSensor::put(observation, i, Derived::number(simulator, kAxes[i].joint, kAxes[i].axis));
  }
};

/// Every tick: observation [n] := Derived::numbers(simulator, body), an array of n numbers.
template <class Io, class Derived>
class BodySensor : public RigidSensor<Io, BodySensor<Io, Derived>> {
 public:
  template <class Simulator, class Message>
  static void sense(const Simulator& simulator, Message& observation) {
    constexpr std::size_t kBody = scene::find(Simulator::Model::kBodies, Io::Config::body);
    static_assert(kBody < Simulator::Model::kBodies.size(),
                  "sensor of a body: `body` is not a body of the object's model");
    const auto numbers = Derived::numbers(simulator, kBody);
    constexpr std::size_t kSize = size_of<std::remove_cvref_t<decltype(numbers)>>;
    static_assert(size_of<Message> == kSize);
    for (std::size_t i = 0; i < kSize; ++i) BodySensor::put(observation, i, numbers[i]);
  }
};

/// A constant of a configuration, as the simulator takes numbers.
template <class Simulator>
constexpr typename Simulator::Number number_for(double value) {
  using Number = typename Simulator::Number;
  return Number(static_cast<LaneOf<Number>>(value));
}

/// Derived::command(simulator, joint, place, value) for each of `joints`, hinges and sliders;
/// `place` counts them.
template <class Io, class Derived>
class JointActuator : public Actuator<Io, JointActuator<Io, Derived>> {
 public:
  using Simulator = typename Io::Simulator;

  template <class Message>
  static void apply(Simulator& simulator, const Message& action) {
    using Joints = JointList<typename Simulator::Model, typename Io::Config>;
    static_assert(Joints::has_only_hinges_and_sliders(),
                  "actuator of joints: `joints` must be hinges and sliders");
    static_assert(Joints::kCount == size_of<Message>,
                  "actuator of joints: the action must have one value for each joint");
    for (std::size_t i = 0; i < Joints::kCount; ++i)
      Derived::command(simulator, Joints::kJoints[i], i,
                       static_cast<typename Simulator::Number>(element(action, i)));
  }
};

}  // namespace eagerx::models

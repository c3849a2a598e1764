// A model-based controller of a robot's joints.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/engines/multibody_engine/robot_dynamics.hpp>
#include <models/nodes/robot_block.hpp>

namespace eagerx::models {

/// u [joints] = M(q)·(goal_a + kd·(goal_v − v) + kp·(goal − q)) + h(q, v) + damping·v, clamped.
template <class Io>
class ComputedTorque : public TorqueBlock<Io> {
  using Base = TorqueBlock<Io>;
  using typename Base::Config, typename Base::Joints, typename Base::Model;
  using typename Base::Numbers, typename Base::Real;
  static_assert(is_one_or_each(Config::kp, Base::kJoints) &&
                    is_one_or_each(Config::kd, Base::kJoints),
                "ComputedTorque: `kp` and `kd` have one value, or one for each joint");

 public:
  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const Numbers q = Base::of_joints(in.q), v = Base::of_joints(in.v);
    const Numbers goal = Base::of_joints(in.goal);
    Numbers goal_v = Base::zeros(), a = goal_v;
    if constexpr (requires { in.goal_v; }) goal_v = Base::of_joints(in.goal_v);
    if constexpr (requires { in.goal_a; }) a = Base::of_joints(in.goal_a);
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] = a[i] + Base::setting(Config::kd, i) * (goal_v[i] - v[i]) +
             Base::setting(Config::kp, i) * (goal[i] - q[i]);
    multibody::RobotDynamics<Model, Joints, Real> robot(Base::places(q));
    Base::put_torques(robot.torques(Base::rates(v), Base::rates(a), Base::gravity()), out);
  }
};

}  // namespace eagerx::models

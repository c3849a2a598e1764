// The torques of a motion.
#pragma once

#include <eagerx/rate.hpp>
#include <models/engines/multibody_engine/robot_dynamics.hpp>
#include <models/nodes/robot_block.hpp>

namespace eagerx::models {

/// u [joints] = M(q)·a + h(q, v) + damping·v, clamped. Without inputs `v` and `a` they are 0. If an
/// input is not finite or is missing, u is zero, moved into its limits.
template <class Io>
class InverseDynamics : public TorqueBlock<Io> {
  using Base = TorqueBlock<Io>;
  using typename Base::Joints, typename Base::Model, typename Base::Numbers, typename Base::Real;

 public:
  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    Numbers v = Base::zeros(), a = v;
    if constexpr (requires { in.v; }) v = Base::of_joints(in.v);
    if constexpr (requires { in.a; }) a = Base::of_joints(in.a);
    multibody::RobotDynamics<Model, Joints, Real> robot(Base::places(Base::of_joints(in.q)));
    Base::put_torques(robot.torques(Base::rates(v), Base::rates(a), Base::gravity()), out);
  }
};

}  // namespace eagerx::models

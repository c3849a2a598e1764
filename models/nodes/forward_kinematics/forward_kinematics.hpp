// Position of a point of a robot.
#pragma once

#include <eagerx/rate.hpp>
#include <models/engines/multibody_engine/robot_reach.hpp>
#include <models/nodes/robot_block.hpp>

namespace eagerx::models {

/// pose [7] = position [m] and quaternion [w, x, y, z] of `point` of `body` at q.
template <class Io>
class ForwardKinematics : public RobotBlock<Io> {
  using Base = RobotBlock<Io>;
  using typename Base::Config, typename Base::Joints, typename Base::Model, typename Base::Real;
  static constexpr std::size_t kBody = PointOfRobot<Io>::kBody;

 public:
  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const multibody::Reach<Model, Joints, Real, kBody> hand(Base::places(Base::of_joints(in.q)),
                                                            Base::vector(Config::point));
    const auto& p = hand.position;
    const auto& r = hand.rotation;
    const Real pose[7] = {p.x, p.y, p.z, r.w, r.x, r.y, r.z};
    for (std::size_t i = 0; i < 7; ++i) put(out.pose, i, pose[i]);
  }
};

}  // namespace eagerx::models

// Jacobian of a point of a robot.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/engines/multibody_engine/robot_reach.hpp>
#include <models/nodes/robot_block.hpp>

namespace eagerx::models {

/// matrix [6][joints]: velocity [m/s] and angular velocity [rad/s] of `point` of `body` for each
/// unit of velocity of a joint, at q.
template <class Io>
class Jacobian : public RobotBlock<Io> {
  using Base = RobotBlock<Io>;
  using typename Base::Config, typename Base::Joints, typename Base::Model, typename Base::Real;
  static_assert(elements_of<decltype(Io::Outputs::matrix)> == 6 * Base::kJoints,
                "Jacobian: `size` is the number of `joints`");
  static constexpr std::size_t kBody = PointOfRobot<Io>::kBody;

 public:
  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const multibody::Reach<Model, Joints, Real, kBody> hand(Base::places(Base::of_joints(in.q)),
                                                            Base::vector(Config::point));
    const auto matrix = hand.jacobian();
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t k = 0; k < Base::kJoints; ++k)
        put(out.matrix, i * Base::kJoints + k, matrix[i][k]);
    }
  }
};

}  // namespace eagerx::models

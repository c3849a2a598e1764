// The heading that the robot should have.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>

namespace turning {

/// From the last `pose` [7]: the angle `error` [1] in rad to a course that turns at `turn` [1] in
/// rad/s, which is sampled at a reset; see the manifest.
template <class Io>
class Course {
 public:
  void reset(const typename Io::States& states) {
    if (states.turn) turn_ = *states.turn;
  }

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    const auto& q = in.pose.back();  // the quaternion begins at 3
    const float heading = eagerx::atan2(2.0F * (q[3] * q[6] + q[4] * q[5]),
                                        1.0F - 2.0F * (q[5] * q[5] + q[6] * q[6]));
    const float error = turn_ * Io::Rate::template seconds<float>(tick.n) - heading;
    out.turn[0] = turn_;
    out.error[0] = eagerx::atan2(eagerx::sin(error), eagerx::cos(error));
  }

 private:
  float turn_ = static_cast<float>(Io::Config::turn);
};

}  // namespace turning

// The motion of a trunk in its own axes.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/block.hpp>

namespace walking {

/// velocity [3] in m/s, angular_velocity [3] in rad/s, gravity [3] and the heights `knees` [4] in m
/// of the last pose [7], twist [6] and position [12]; see the manifest.
template <class Io>
class BodyMotion {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    using eagerx::models::newest;
    using eagerx::models::put;
    const Axes r = axes(newest<Real>(in.pose, 3), newest<Real>(in.pose, 4),
                        newest<Real>(in.pose, 5), newest<Real>(in.pose, 6));
    for (std::size_t i = 0; i < 3; ++i) {
      Real velocity(0);
      Real spin(0);
      for (std::size_t j = 0; j < 3; ++j) {
        velocity = velocity + r[j][i] * newest<Real>(in.twist, j);
        spin = spin + r[j][i] * newest<Real>(in.twist, 3 + j);
      }
      put(out.velocity, i, velocity);
      put(out.angular_velocity, i, spin);
      put(out.gravity, i, -r[2][i]);
    }
    const Real height = newest<Real>(in.pose, 2);
    for (std::size_t leg = 0; leg < 4; ++leg)
      put(out.knees, leg,
          height + knee(leg, r[2], newest<Real>(in.position, 3 * leg),
                        newest<Real>(in.position, 3 * leg + 1)));
  }

 private:
  using Real = typename Io::Real;
  using Lane = eagerx::LaneOf<Real>;
  using Axes = std::array<std::array<Real, 3>, 3>;

  /// The rotation matrix of a quaternion of length 1.
  static Axes axes(const Real& w, const Real& x, const Real& y, const Real& z) {
    const Real one(1);
    const Real two(2);
    return {{{{one - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)}},
             {{two * (x * y + w * z), one - two * (x * x + z * z), two * (y * z - w * x)}},
             {{two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)}}}};
  }

  /// Height of a knee over the trunk: `up` is the world's z axis in the trunk's.
  static Real knee(std::size_t leg, const std::array<Real, 3>& up, const Real& hip,
                   const Real& thigh) {
    const Real front(leg < 2 ? Lane(1) : Lane(-1));
    const Real left(leg % 2 == 0 ? Lane(1) : Lane(-1));
    const Real length(Lane(0.2));
    const Real side = left * Real(Lane(0.0838));
    const Real down = length * eagerx::cos(thigh);
    const Real s = eagerx::sin(hip);
    const Real c = eagerx::cos(hip);
    const Real x = front * Real(Lane(0.1805)) - length * eagerx::sin(thigh);
    const Real y = left * Real(Lane(0.047)) + (c * side + s * down);
    const Real z = s * side - c * down;
    return up[0] * x + up[1] * y + up[2] * z;
  }
};

}  // namespace walking

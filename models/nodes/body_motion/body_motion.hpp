// The motion of a trunk in its own axes.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// velocity [3] in m/s, angular_velocity [3] in rad/s and the direction `gravity` [3] of the last
/// pose [7] and twist [6]; see the manifest.
template <class Io>
class BodyMotion {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
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
  }

 private:
  using Real = typename Io::Real;
  using Axes = std::array<std::array<Real, 3>, 3>;

  /// The rotation matrix of a quaternion of length 1.
  static Axes axes(const Real& w, const Real& x, const Real& y, const Real& z) {
    const Real one(1);
    const Real two(2);
    return {{{{one - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)}},
             {{two * (x * y + w * z), one - two * (x * x + z * z), two * (y * z - w * x)}},
             {{two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)}}}};
  }
};

}  // namespace eagerx::models

// From the observation of Gym's pendulum to an angle and a speed.
#pragma once

#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// EAGERx's names for it, of two versions.
enum class ObsConversion : std::uint8_t { theta_theta_dot, theta_dtheta };

/// [cos φ, sin φ, dφ/dt] of Gym's pendulum becomes [θ, dθ/dt] = [−atan2(sin φ, cos φ), −dφ/dt]
/// [rad, rad/s].
/// Source: eagerx_tutorials, pendulum/processor.py.
template <class Io>
struct ObsWithDecomposedAngle {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Scalar = ScalarOf<typename Io::Output>;
    using Real = typename Io::Real;
    static_assert(size_of<typename Io::Input> == 3 && size_of<typename Io::Output> == 2);
    const Real angle = eagerx::atan2(static_cast<Real>(in[1]), static_cast<Real>(in[0]));
    return {{static_cast<Scalar>(-angle), static_cast<Scalar>(-in[2])}};
  }
};

}  // namespace eagerx::models

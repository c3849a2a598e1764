// Shared parts of Gym's two mountain cars.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// The first attributes of both, in Gym's units of length; a step is the unit of time.
enum MountainCarAttribute : std::size_t {
  kMountainForce,  // change of velocity in a step, at full push
  kMountainGravity,
  kMountainMaxSpeed,
  kMountainMinPosition,
  kMountainMaxPosition,
  kMountainGoalPosition,
  kMountainGoalVelocity,
};
inline constexpr std::size_t kMountainCarAttributes = 7;

/// One step of [position, velocity] with the push `change` of velocity. The left wall stops the
/// car. Whether the goal is reached.
template <class Real>
constexpr TruthOf<Real> drive_mountain_car(Array<Real, 2>& state, Real change,
                                           const Array<Real, kMountainCarAttributes>& a) {
  const Real slope = eagerx::cos(Real(3) * state[0]) * -a[kMountainGravity];
  const Real freely =
      eagerx::clamp(state[1] + (change + slope), -a[kMountainMaxSpeed], a[kMountainMaxSpeed]);
  const Real position =
      eagerx::clamp(state[0] + freely, a[kMountainMinPosition], a[kMountainMaxPosition]);
  const auto stopped = position == a[kMountainMinPosition] && freely < Real(0);
  const Real velocity = select(stopped, Real(0), freely);
  state = {{position, velocity}};
  return position >= a[kMountainGoalPosition] && velocity >= a[kMountainGoalVelocity];
}

}  // namespace eagerx::models

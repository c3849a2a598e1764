// Gym's MountainCar-v0 as a model of GymEngine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <models/engines/gym_engine/gym_model.hpp>
#include <models/objects/gym_mountain_car/mountain_car.hpp>

namespace eagerx::models {

/// State [x, v], position and its change in a step; the valley is sin(3x). Action 0 pushes to the
/// left, 1 not at all, 2 to the right. A step:
///   v ← v + (action − 1)·force − gravity·cos(3x), clipped to ±max_speed
///   x ← x + v, clipped to min_position…max_position; at the left wall v ≥ 0
/// Terminated at the goal. Each step costs 1.
/// Source: Gymnasium 1.4.0, envs/classic_control/mountain_car.py.
template <class Io>
struct GymMountainCar {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kActions = 1;
  static constexpr std::size_t kObservations = 2;
  static constexpr std::size_t kAttributes = kMountainCarAttributes;
  static constexpr std::uint32_t kMaxSteps = 200;
  static constexpr std::array<const char*, kAttributes> kAttributeNames = {
      "force",        "gravity",       "max_speed",    "min_position",
      "max_position", "goal_position", "goal_velocity"};

  static constexpr Array<Real, kStates> initial_state() { return {{Real(-0.5), Real(0)}}; }
  static constexpr Array<Real, kAttributes> default_attributes() {
    return {{Real(0.001), Real(0.0025), Real(0.07), Real(-1.2), Real(0.6), Real(0.5), Real(0)}};
  }

  static constexpr GymOutcome<Real> step(Array<Real, kStates>& state,
                                         const Array<Real, kActions>& action,
                                         const Array<Real, kAttributes>& a) {
    const Real push = eagerx::clamp(action[0], Real(0), Real(2)) - Real(1);
    const TruthOf<Real> arrived = drive_mountain_car(state, push * a[kMountainForce], a);
    return {.reward = Real(-1), .terminated = arrived};
  }

  static constexpr Array<Real, kObservations> observe(const Array<Real, kStates>& state) {
    return state;
  }
};

}  // namespace eagerx::models

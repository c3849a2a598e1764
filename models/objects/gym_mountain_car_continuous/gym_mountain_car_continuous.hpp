// Gym's MountainCarContinuous-v0 as a model of GymEngine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <models/engines/gym_engine/gym_model.hpp>
#include <models/objects/gym_mountain_car/mountain_car.hpp>
#include <type_traits>

namespace eagerx::models {

/// State [x, v], position and its change in a step; the valley is sin(3x). Action: the push u. A
/// step:
///   v ← v + power·u − 0.0025·cos(3x), u clipped to ±1, v to ±max_speed
///   x ← x + v, clipped to min_position…max_position; at the left wall v ≥ 0
///   reward = −0.1·u² with u as it was given, and 100 at the goal, which terminates
/// Gym keeps this state in float32; so does this model, whatever Real is.
/// Source: Gymnasium 1.4.0, envs/classic_control/continuous_mountain_car.py.
template <class Io>
struct GymMountainCarContinuous {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kActions = 1;
  static constexpr std::size_t kObservations = 2;
  static constexpr std::size_t kAttributes = kMountainCarAttributes;
  static constexpr std::uint32_t kMaxSteps = 999;
  static constexpr std::array<const char*, kAttributes> kAttributeNames = {
      "power",        "gravity",       "max_speed",    "min_position",
      "max_position", "goal_position", "goal_velocity"};

  static constexpr Array<Real, kStates> initial_state() { return {{Real(-0.5), Real(0)}}; }
  static constexpr Array<Real, kAttributes> default_attributes() {
    return {{Real(0.0015), Real(0.0025), Real(0.07), Real(-1.2), Real(0.6), Real(0.45), Real(0)}};
  }

  static constexpr GymOutcome<Real> step(Array<Real, kStates>& state,
                                         const Array<Real, kActions>& action,
                                         const Array<Real, kAttributes>& a) {
    const Real push = eagerx::clamp(action[0], Real(-1), Real(1));
    const TruthOf<Real> arrived = drive_mountain_car(state, push * a[kMountainForce], a);
    if constexpr (!std::is_same_v<LaneOf<Real>, float>) {
      for (std::size_t i = 0; i < kStates; ++i)
        state[i] = static_cast<Real>(static_cast<float>(state[i]));
    }
    const Real goal = select(arrived, Real(100), Real(0));
    return {.reward = goal - action[0] * action[0] * Real(0.1), .terminated = arrived};
  }

  static constexpr Array<Real, kObservations> observe(const Array<Real, kStates>& state) {
    return state;
  }
};

}  // namespace eagerx::models

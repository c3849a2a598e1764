// The motor of motor.hpp for the simulation: a step of GymEngine is a period of the controller.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <models/engines/gym_engine/gym_model.hpp>

#include "../../motor.hpp"

template <class Io>
struct MotorModel {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2, kActions = 1, kObservations = 1, kAttributes = 1;
  static constexpr std::uint32_t kMaxSteps = 0;  // never truncated
  static constexpr std::array<const char*, kAttributes> kAttributeNames = {"none"};
  using State = eagerx::Array<Real, kStates>;  // rad, rad/s
  using Attributes = eagerx::Array<Real, kAttributes>;

  static constexpr State initial_state() { return {}; }
  static constexpr Attributes default_attributes() { return {}; }

  static constexpr eagerx::models::GymOutcome<Real> step(
      State& state, const eagerx::Array<Real, kActions>& voltage, const Attributes& /*none*/) {
    Motor::move(state[0], state[1], voltage[0]);
    return {};
  }
  static constexpr eagerx::Array<Real, kObservations> observe(const State& state) {
    return {{state[0]}};
  }
};

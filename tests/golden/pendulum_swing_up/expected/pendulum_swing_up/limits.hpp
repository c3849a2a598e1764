// Limits of the actions and observations of graph `pendulum_swing_up`, and the safe action.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <array>
#include <eagerx/safety.hpp>
#include <eagerx/space.hpp>

#include "pendulum_swing_up/messages.hpp"

namespace graphs::pendulum_swing_up {

struct Limits {
  using Action = graphs::pendulum_swing_up::Action;
  using Observation = graphs::pendulum_swing_up::Observation;

  /// actions.voltage
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kActionVoltage{.low = {{-2.0F}},
                                                                         .high = {{2.0F}}};
  /// observations.angle
  static constexpr eagerx::Space<eagerx::Array<float, 2>> kObservationAngle{.low = {{-1.0F, -1.0F}},
                                                                            .high = {{1.0F, 1.0F}}};
  /// observations.theta_dot
  static constexpr eagerx::Space<float> kObservationThetaDot{.low = -999.0F, .high = 999.0F};

  static constexpr std::array<const char*, 1> kActionNames{"voltage"};
  static constexpr std::array<const char*, 2> kObservationNames{"angle", "theta_dot"};
  /// Whether an observation may have no message yet, because the graph says so.
  static constexpr std::array<bool, 2> kMayWait{false, false};

  /// When the safe action takes the agent's place.
  static constexpr eagerx::Safety kSafety{.declared = false,
                                          .late = 1,
                                          .max_lateness_ns = 33333333,
                                          .link_timeout_ns = 10000000,
                                          .heartbeat_timeout_ns = 500000000,
                                          .missed = 2,
                                          .recover = 3,
                                          .clips = true,
                                          .holds = false};
  /// The safe action.
  [[nodiscard]] static Action safe() { return {.voltage = {{0.0F}}}; }

  /// f(name, message, space) for each action.
  template <class F>
  static void for_each_action(Action& action, F&& f) {
    f("voltage", action.voltage, kActionVoltage);
  }
  /// f(message, space) for each action, with what it and all actuators that get it have in common.
  template <class F>
  static void for_each_applied(Action& action, F&& f) {
    f(action.voltage, kActionVoltage);
  }
  /// f(name, window, space) for each observation.
  template <class F>
  static void for_each_observation(const Observation& observation, F&& f) {
    f("angle", observation.angle, kObservationAngle);
    f("theta_dot", observation.theta_dot, kObservationThetaDot);
  }
};

}  // namespace graphs::pendulum_swing_up

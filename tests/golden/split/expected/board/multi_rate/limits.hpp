// Limits of the actions and observations of graph `multi_rate`, and the safe action.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <array>
#include <eagerx/safety.hpp>
#include <eagerx/space.hpp>

#include "multi_rate/messages.hpp"

namespace graphs::multi_rate {

struct Limits {
  using Action = graphs::multi_rate::Action;
  using Observation = graphs::multi_rate::Observation;

  /// actions.voltage
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kActionVoltage{.low = {{-2.0F}},
                                                                         .high = {{2.0F}}};
  /// actions.push
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kActionPush{.low = {{-1.0F}},
                                                                      .high = {{1.0F}}};
  /// observations.angle
  static constexpr eagerx::Space<eagerx::Array<float, 2>> kObservationAngle{.low = {{-1.0F, -1.0F}},
                                                                            .high = {{1.0F, 1.0F}}};
  /// observations.speeds
  static constexpr eagerx::Space<float> kObservationSpeeds{.low = -999.0F, .high = 999.0F};
  /// observations.recent
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kObservationRecent{.low = {{-1.0F}},
                                                                             .high = {{1.0F}}};
  /// observations.applied
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kObservationApplied{.low = {{-2.0F}},
                                                                              .high = {{2.0F}}};
  /// observations.other
  static constexpr eagerx::Space<float> kObservationOther{.low = -999.0F, .high = 999.0F};

  static constexpr std::array<const char*, 2> kActionNames{"voltage", "push"};
  static constexpr std::array<const char*, 5> kObservationNames{"angle", "speeds", "recent",
                                                                "applied", "other"};
  /// Whether an observation may have no message yet, because the graph says so.
  static constexpr std::array<bool, 5> kMayWait{false, false, true, true, false};

  /// When the safe action takes the agent's place.
  static constexpr eagerx::Safety kSafety{.declared = false,
                                          .late = 1,
                                          .max_lateness_ns = 100000000,
                                          .link_timeout_ns = 10000000,
                                          .heartbeat_timeout_ns = 500000000,
                                          .missed = 2,
                                          .recover = 3,
                                          .clips = true,
                                          .holds = false};
  /// The safe action.
  [[nodiscard]] static Action safe() { return {.voltage = {{0.0F}}, .push = {{0.0F}}}; }

  /// f(name, message, space) for each action.
  template <class F>
  static void for_each_action(Action& action, F&& f) {
    f("voltage", action.voltage, kActionVoltage);
    f("push", action.push, kActionPush);
  }
  /// f(message, space) for each action, with what it and all actuators that get it have in common.
  template <class F>
  static void for_each_applied(Action& action, F&& f) {
    f(action.voltage, kActionVoltage);
    f(action.push, kActionPush);
  }
  /// f(name, window, space) for each observation.
  template <class F>
  static void for_each_observation(const Observation& observation, F&& f) {
    f("angle", observation.angle, kObservationAngle);
    f("speeds", observation.speeds, kObservationSpeeds);
    f("recent", observation.recent, kObservationRecent);
    f("applied", observation.applied, kObservationApplied);
    f("other", observation.other, kObservationOther);
  }
};

}  // namespace graphs::multi_rate

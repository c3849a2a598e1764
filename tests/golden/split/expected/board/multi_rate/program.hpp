// Graph `multi_rate` on OdeEngine: its memory, its schedule, one step.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
//
// Every node appears once, in data-flow order, under the bit of its rate. A slot is an instant at
// which at least one rate is due; the 12 slots of the hyperperiod are a table of which of them are
// alike.
#pragma once

#include <cstdint>
#include <eagerx/cursor.hpp>
#include <eagerx/engine.hpp>
#include <eagerx/guard.hpp>
#include <eagerx/hooks.hpp>
#include <eagerx/link/star.hpp>
#include <eagerx/memory_fault.hpp>
#include <eagerx/schedule.hpp>

#include "multi_rate/io.hpp"
#include "multi_rate/limits.hpp"

namespace graphs::multi_rate {

/// What runs in part `board` of the graph in one object: no heap, all zero until the first reset. A
/// step is 0.1 s.
template <class Hooks = eagerx::NoHooks, class Link = eagerx::link::NoLink>
class Program {
 public:
  [[no_unique_address]] Hooks hooks;
  /// Between the agent and the actuators; step() asks it.
  eagerx::Guard<Limits> guard{};
  /// The link to the hub of this graph; before the first reset.
  void connect(Link& link) { link_ = &link; }
  [[nodiscard]] Link& link() const { return *link_; }

  /// Starts an episode; the observation of its tick 0. What `states` leaves empty stays as it is.
  Observation reset(const States& /*states*/) & {
    n60Hz_ = 0;
    n30Hz_ = 0;
    n20Hz_ = 0;
    n15Hz_ = 0;
    n10Hz_ = 0;
    guard.reset();
    slot_ = 0;
    fast_.reset({});
    observation_speeds_cursor_.reset(2);  // 0.05 s
    observation_recent_new_.reset();
    observation_other_cursor_.reset(2);  // 1/15 s
    run_before_action(eagerx::Constant<k60Hz | k30Hz | k20Hz | k15Hz | k10Hz>{});
    return observe();
  }
  /// Steps that found their place in the schedule to be none: something had written over it.
  [[nodiscard]] std::uint32_t memory_faults() const { return memory_faults_; }

  /// Applies an action, or what the guard puts in its place, and runs to the next tick of the
  /// environment. `late_in_a_row`: how many steps up to this one were later than
  /// `Limits::kSafety.max_lateness_ns`.
  Observation step(const Action& action, std::uint64_t late_in_a_row = 0) & {
    return step_unguarded(guard.check(action, late_in_a_row));
  }
  /// The safe action, for the end of a run before its time.
  Observation step_safely() & { return step_unguarded(guard.stop()); }
  /// Without the guard: whatever `action` is, the actuators get it.
  Observation step_unguarded(const Action& action) & {
    if (n10Hz_ == 0) [[unlikely]] {
      return before_reset();
    }
    // actions.voltage
    auto& new_voltage = action_voltage_[eagerx::ring_position<4>(n10Hz_ - 1)];
    new_voltage = action.voltage;
    hooks.on_message(channel::environment_voltage, n10Hz_ - 1, new_voltage);
    link_->put(new_voltage);
    // actions.push
    auto& new_push = action_push_[eagerx::ring_position<4>(n10Hz_ - 1)];
    new_push = action.push;
    hooks.on_message(channel::environment_push, n10Hz_ - 1, new_push);
    link_->put(new_push);
    for (std::uint32_t at = slot_ + 1; at < 12; ++at) {
      switch (Slot{kSlotAt[at]}) {
        case Slot::due_60Hz:
          run_before_action(eagerx::Constant<k60Hz>{});
          break;
        case Slot::due_60Hz_30Hz:
          run_before_action(eagerx::Constant<k60Hz | k30Hz>{});
          break;
        case Slot::due_60Hz_20Hz:
          run_before_action(eagerx::Constant<k60Hz | k20Hz>{});
          break;
        case Slot::due_60Hz_30Hz_15Hz:
          run_before_action(eagerx::Constant<k60Hz | k30Hz | k15Hz>{});
          break;
        default:  // Slot::due_60Hz_30Hz_20Hz_10Hz
          slot_ = at;
          run_before_action(eagerx::Constant<k60Hz | k30Hz | k20Hz | k10Hz>{});
          return observe();
      }
    }
    // All rates are due again: the first slot.
    slot_ = 0;
    run_before_action(eagerx::Constant<k60Hz | k30Hz | k20Hz | k15Hz | k10Hz>{});
    return observe();
  }

  /// Steps before the first reset. They do nothing: neither the engine nor a node runs.
  [[nodiscard]] std::uint32_t steps_before_reset() const { return steps_before_reset_; }

 private:
  using Due = std::uint32_t;
  static constexpr Due k60Hz = Due{1} << 0U;
  static constexpr Due k30Hz = Due{1} << 1U;
  static constexpr Due k20Hz = Due{1} << 2U;
  static constexpr Due k15Hz = Due{1} << 3U;
  static constexpr Due k10Hz = Due{1} << 4U;

  [[gnu::noinline, gnu::cold]] Observation before_reset() {
    ++steps_before_reset_;
    return at_rest();
  }
  Observation at_rest() {
    return Observation{.angle = {observation_angle_, 0, 0},
                       .speeds = {left_theta_dot_observation_, 0, 0},
                       .recent = {fast_filtered_, 0, 0},
                       .applied = {left_u_applied_action_applied_, 0, 0},
                       .other = {right_theta_observation_, 0, 0}};
  }

  // Up to the environment: everything that does not need the action of the same instant.
  template <class Mask>
  void run_before_action(const Mask due) {
    if ((due & k60Hz) != 0) {
      ++n60Hz_;
      if constexpr (eagerx::waits_for_slots<Hooks>) {
        hooks.wait_for_slot(eagerx::Rate<60>{}, n60Hz_ - 1);
      }
    }
    if ((due & k30Hz) != 0) {
      ++n30Hz_;
      if constexpr (eagerx::waits_for_slots<Hooks>) {
        hooks.wait_for_slot(eagerx::Rate<30>{}, n30Hz_ - 1);
      }
    }
    if ((due & k20Hz) != 0) {
      ++n20Hz_;
      if constexpr (eagerx::waits_for_slots<Hooks>) {
        hooks.wait_for_slot(eagerx::Rate<20>{}, n20Hz_ - 1);
      }
    }
    if ((due & k15Hz) != 0) {
      ++n15Hz_;
      if constexpr (eagerx::waits_for_slots<Hooks>) {
        hooks.wait_for_slot(eagerx::Rate<15>{}, n15Hz_ - 1);
      }
    }
    if ((due & k10Hz) != 0) {
      ++n10Hz_;
      if constexpr (eagerx::waits_for_slots<Hooks>) {
        hooks.wait_for_slot(eagerx::Rate<10>{}, n10Hz_ - 1);
      }
    }
    if (!link_->ok()) {
      return;
    }
    if ((due & k30Hz) != 0) {
      const eagerx::Seq n = n30Hz_ - 1;
      // fast: ButterworthFilter
      {
        const FastIo::Inputs in{.signal = {action_push_, n10Hz_ - ((due & k10Hz) != 0 ? 1U : 0U)}};
        auto& new_filtered = fast_filtered_[eagerx::ring_position<4>(n)];
        eagerx::Array<float, 1> raw_filtered{};
        FastIo::Outputs out{.filtered = raw_filtered};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("fast", FastIo::Rate{}, n, in);
        }
        fast_.callback(eagerx::Tick{n}, in, out);
        new_filtered = FastFilteredProcessor::convert(raw_filtered);
        hooks.on_message(channel::fast_filtered, n, new_filtered);
        link_->put(new_filtered);
      }
    }
    if ((due & k20Hz) != 0) {
      const eagerx::Seq n = n20Hz_ - 1;
      // left/theta: FloatOutput
      {
        if (!link_->get(left_theta_observation_[0])) {
          return;
        }
        hooks.on_message(channel::left_theta_observation, n, left_theta_observation_[0]);
        observation_angle_[eagerx::ring_position<2>(n)] =
            ObservationAngleProcessor::convert(left_theta_observation_[0]);
      }
    }
    if ((due & k30Hz) != 0) {
      const eagerx::Seq n = n30Hz_ - 1;
      // left/theta_dot: FloatOutput
      {
        auto& new_observation = left_theta_dot_observation_[eagerx::ring_position<8>(n)];
        if (!link_->get(new_observation)) {
          return;
        }
        hooks.on_message(channel::left_theta_dot_observation, n, new_observation);
      }
    }
    if ((due & k15Hz) != 0) {
      const eagerx::Seq n = n15Hz_ - 1;
      // right/theta: FloatOutput
      {
        auto& new_observation = right_theta_observation_[eagerx::ring_position<2>(n)];
        if (!link_->get(new_observation)) {
          return;
        }
        hooks.on_message(channel::right_theta_observation, n, new_observation);
      }
    }
    if ((due & k10Hz) != 0) {
      const eagerx::Seq n = n10Hz_ - 1;
      // left/u_applied: ActionApplied
      {
        auto& new_action_applied = left_u_applied_action_applied_[eagerx::ring_position<2>(n)];
        if (!link_->get(new_action_applied)) {
          return;
        }
        hooks.on_message(channel::left_u_applied_action_applied, n, new_action_applied);
      }
    }
  }

  // The observation of the environment.
  Observation observe() {
    const Observation observation{
        .angle = {observation_angle_, n20Hz_},
        .speeds = {left_theta_dot_observation_, observation_speeds_cursor_.take()},
        .recent = {fast_filtered_, observation_recent_new_.take(n30Hz_ - 1)},
        .applied = {left_u_applied_action_applied_, n10Hz_ - 1},
        .other = {right_theta_observation_, observation_other_cursor_.take()}};
    guard.see(observation);
    if constexpr (eagerx::sees_inputs<Hooks>) {
      hooks.on_inputs("environment", eagerx::Rate<10>{}, n10Hz_ - 1, observation);
    }
    return observation;
  }

  // The kinds of slots: the rates that are due.
  enum class Slot : std::uint8_t {
    due_60Hz_30Hz_20Hz_15Hz_10Hz,
    due_60Hz,
    due_60Hz_30Hz,
    due_60Hz_20Hz,
    due_60Hz_30Hz_15Hz,
    due_60Hz_30Hz_20Hz_10Hz,
  };
  // The kind of every slot, by its number in Slot.
  static constexpr std::uint8_t kSlotAt[12] = {0, 1, 2, 3, 4, 1, 5, 1, 4, 3, 2, 1};
  std::uint32_t slot_ = 0;  // of the last observation

  // The place in the schedule is none: something wrote over it. The engine makes itself safe, and
  // eagerx_memory_fault() decides, if it is defined; a board ends as after any other fault. Else it
  // is as before the first reset, until there is one.
  [[gnu::noinline, gnu::cold]] Observation memory_fault() {
    ++memory_faults_;
    eagerx::tell_memory_fault();
    n10Hz_ = 0;
    return at_rest();
  }
  std::uint32_t memory_faults_ = 0;

  Link* link_ = nullptr;
  std::uint32_t steps_before_reset_ = 0;
  // Ticks so far, one counter a rate.
  eagerx::Seq n60Hz_ = 0;
  eagerx::Seq n30Hz_ = 0;
  eagerx::Seq n20Hz_ = 0;
  eagerx::Seq n15Hz_ = 0;
  eagerx::Seq n10Hz_ = 0;

  // Messages received, where that is not simply what was sent.
  eagerx::DelayCursor<3, 1> observation_speeds_cursor_{};  // observations.speeds
  eagerx::NewMessages observation_recent_new_{};           // observations.recent
  eagerx::DelayCursor<3, 2> observation_other_cursor_{};   // observations.other

  // Messages: as many of each as its readers need.
  eagerx::Array<float, 1> action_voltage_[4]{};  // slow.signal needs 3
  eagerx::Array<float, 1> action_push_[4]{};     // fast.signal needs 3
  eagerx::Array<float, 1> fast_filtered_[4]{};   // observations.recent needs 4
  float left_theta_observation_[1]{};
  float left_theta_dot_observation_[8]{};                       // observations.speeds needs 6
  eagerx::Array<float, 1> left_u_applied_action_applied_[2]{};  // observations.applied needs 2
  float right_theta_observation_[2]{};                          // observations.other needs 2
  eagerx::Array<float, 2> observation_angle_[2]{};              // observations.angle needs 2

  // Simulators, engine and nodes.
  eagerx::models::ButterworthFilter<FastIo> fast_{};
};

}  // namespace graphs::multi_rate

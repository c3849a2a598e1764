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
#include <eagerx/memory_fault.hpp>
#include <eagerx/schedule.hpp>

#include "multi_rate/io.hpp"
#include "multi_rate/limits.hpp"

namespace graphs::multi_rate {

/// The whole graph in one object: no heap, all zero until the first reset. A step is 0.1 s.
template <class Hooks = eagerx::NoHooks>
class Program {
 public:
  [[no_unique_address]] Hooks hooks;
  /// Between the agent and the actuators; step() asks it.
  eagerx::Guard<Limits> guard{};

  /// Once: engine and simulators get what they need, memory too if they are built on a library.
  /// The first reset does it if it is not done yet.
  void warm_up() {
    if (warm_) {
      return;
    }
    warm_ = true;
    if (eagerx::runs_engine(hooks)) {
      eagerx::start(engine_, left_simulator_, right_simulator_);
    }
  }
  /// At the end of a run: an engine of real hardware lets it come to rest.
  void stop() {
    if (eagerx::runs_engine(hooks)) {
      eagerx::stop(engine_, left_simulator_, right_simulator_);
    }
  }
  /// Outside of a step, when what decides is silent or about to stop: an engine of real hardware
  /// applies its safe actions.
  void make_safe() {
    if (eagerx::runs_engine(hooks)) {
      eagerx::make_safe(engine_, left_simulator_, right_simulator_);
    }
  }
  /// In a copy of this program, when it was killed: opens hardware anew and makes it safe, as its
  /// actuators declare it.
  void take_over() {
    warm_up();
    fast_.reset({});
    right_u_applied_.reset({}, right_simulator_);
    left_x_.reset({}, left_simulator_);
    left_theta_.reset({}, left_simulator_);
    right_u_.reset({}, right_simulator_);
    left_theta_dot_.reset({}, left_simulator_);
    right_x_.reset({}, right_simulator_);
    right_theta_.reset({}, right_simulator_);
    left_u_applied_.reset({}, left_simulator_);
    slow_.reset({});
    left_u_.reset({}, left_simulator_);
    stop();
  }
  /// Whether the engine acts on the world itself.
  [[nodiscard]] bool is_real() const {
    return eagerx::is_real(engine_, left_simulator_, right_simulator_);
  }
  /// f(name, count) for what engine, objects and nodes count besides messages. A name is valid
  /// during its call.
  template <class F>
  void for_each_count(F&& f) const {
    eagerx::for_each_count(f, engine_, left_simulator_, right_simulator_);
  }

  /// Starts an episode; the observation of its tick 0. What `states` leaves empty stays as it is.
  Observation reset(const States& states) & {
    n60Hz_ = 0;
    n30Hz_ = 0;
    n20Hz_ = 0;
    n15Hz_ = 0;
    n10Hz_ = 0;
    guard.reset();
    slot_ = 0;
    if (!started_) {
      warm_up();
      started_ = true;
    }
    if (eagerx::runs_engine(hooks)) {
      if (states.left_model_state) {
        LeftModelState::reset(*states.left_model_state, left_simulator_);
      }
      if (states.left_mass) {
        LeftMass::reset(*states.left_mass, left_simulator_);
      }
      if (states.left_length) {
        LeftLength::reset(*states.left_length, left_simulator_);
      }
      if (states.right_model_state) {
        RightModelState::reset(*states.right_model_state, right_simulator_);
      }
      if (states.right_max_speed) {
        RightMaxSpeed::reset(*states.right_max_speed, right_simulator_);
      }
      if (states.right_length) {
        RightLength::reset(*states.right_length, right_simulator_);
      }
      eagerx::reset_engine(engine_, EngineIo::States{}, left_simulator_, right_simulator_);
    }
    fast_.reset({});
    right_u_applied_.reset({}, right_simulator_);
    left_x_.reset({}, left_simulator_);
    left_theta_.reset({}, left_simulator_);
    right_u_.reset({}, right_simulator_);
    left_theta_dot_.reset({}, left_simulator_);
    right_x_.reset({}, right_simulator_);
    right_theta_.reset({}, right_simulator_);
    left_u_applied_.reset({}, left_simulator_);
    slow_.reset({});
    left_u_.reset({}, left_simulator_);
    observation_speeds_cursor_.reset(2);  // 0.05 s
    observation_recent_new_.reset();
    observation_other_cursor_.reset(2);  // 1/15 s
    slow_signal_cursor_.reset(3);        // 0.12 s
    right_u_applied_action_applied_cursor_.reset(0);
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
    // actions.push
    auto& new_push = action_push_[eagerx::ring_position<4>(n10Hz_ - 1)];
    new_push = action.push;
    hooks.on_message(channel::environment_push, n10Hz_ - 1, new_push);
    if (slot_ >= 12) {
      return memory_fault();
    }
    // The slot of the last observation continues, then come those up to the next.
    switch (Slot{kSlotAt[slot_]}) {
      case Slot::due_60Hz_30Hz_20Hz_15Hz_10Hz:
        run_after_action(eagerx::Constant<k60Hz | k30Hz | k20Hz | k15Hz | k10Hz>{});
        break;
      case Slot::due_60Hz_30Hz_20Hz_10Hz:
        run_after_action(eagerx::Constant<k60Hz | k30Hz | k20Hz | k10Hz>{});
        break;
      default:
        return memory_fault();
    }
    for (std::uint32_t at = slot_ + 1; at < 12; ++at) {
      switch (Slot{kSlotAt[at]}) {
        case Slot::due_60Hz:
          run_slot(eagerx::Constant<k60Hz>{});
          break;
        case Slot::due_60Hz_30Hz:
          run_slot(eagerx::Constant<k60Hz | k30Hz>{});
          break;
        case Slot::due_60Hz_20Hz:
          run_slot(eagerx::Constant<k60Hz | k20Hz>{});
          break;
        case Slot::due_60Hz_30Hz_15Hz:
          run_slot(eagerx::Constant<k60Hz | k30Hz | k15Hz>{});
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
    if ((due & k60Hz) != 0) {
      const eagerx::Seq n = n60Hz_ - 1;
      // engine: OdeEngine
      {
        if (n > 0 && eagerx::runs_engine(hooks)) {
          engine_.callback(eagerx::Tick{n}, left_simulator_, right_simulator_);
        }
        engine_tick_[0] = static_cast<std::int64_t>(n);
        hooks.on_message(channel::engine_tick, n, engine_tick_[0]);
        if constexpr (eagerx::sees_simulators<Hooks>) {
          hooks.on_simulator("left", n, left_simulator_);
          hooks.on_simulator("right", n, right_simulator_);
        }
      }
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
        right_u_action_[0] = RightUActionProcessor::convert(new_filtered);
      }
      // right/u_applied: ActionApplied
      {
        const RightUAppliedIo::Inputs in{
            .tick = {engine_tick_, n60Hz_},
            .action_applied = {right_u_action_applied_,
                               right_u_applied_action_applied_cursor_.take()}};
        RightUAppliedIo::Outputs out{.action_applied = right_u_applied_action_applied_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("right/u_applied", RightUAppliedIo::Rate{}, n, in);
        }
        right_u_applied_.callback(eagerx::Tick{n}, in, out, right_simulator_);
        hooks.on_message(channel::right_u_applied_action_applied, n,
                         right_u_applied_action_applied_[0]);
      }
    }
    if ((due & k20Hz) != 0) {
      const eagerx::Seq n = n20Hz_ - 1;
      // left/x: OdeOutput
      {
        const LeftXIo::Inputs in{.tick = {engine_tick_, n60Hz_}};
        LeftXIo::Outputs out{.observation = left_x_observation_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("left/x", LeftXIo::Rate{}, n, in);
        }
        left_x_.callback(eagerx::Tick{n}, in, out, left_simulator_);
        hooks.on_message(channel::left_x_observation, n, left_x_observation_[0]);
      }
      // left/theta: FloatOutput
      {
        const LeftThetaIo::Inputs in{.observation_array = {left_x_observation_, n20Hz_}};
        LeftThetaIo::Outputs out{.observation = left_theta_observation_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("left/theta", LeftThetaIo::Rate{}, n, in);
        }
        left_theta_.callback(eagerx::Tick{n}, in, out, left_simulator_);
        hooks.on_message(channel::left_theta_observation, n, left_theta_observation_[0]);
        observation_angle_[eagerx::ring_position<2>(n)] =
            ObservationAngleProcessor::convert(left_theta_observation_[0]);
      }
      // right/u: OdeInput
      {
        const RightUIo::Inputs in{.tick = {engine_tick_, n60Hz_},
                                  .action = {right_u_action_, n30Hz_}};
        RightUIo::Outputs out{.action_applied = right_u_action_applied_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("right/u", RightUIo::Rate{}, n, in);
        }
        right_u_.callback(eagerx::Tick{n}, in, out, right_simulator_);
        hooks.on_message(channel::right_u_action_applied, n, right_u_action_applied_[0]);
      }
    }
    if ((due & k30Hz) != 0) {
      const eagerx::Seq n = n30Hz_ - 1;
      // left/theta_dot: FloatOutput
      {
        const LeftThetaDotIo::Inputs in{.observation_array = {left_x_observation_, n20Hz_}};
        auto& new_observation = left_theta_dot_observation_[eagerx::ring_position<8>(n)];
        float raw_observation{};
        LeftThetaDotIo::Outputs out{.observation = raw_observation};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("left/theta_dot", LeftThetaDotIo::Rate{}, n, in);
        }
        left_theta_dot_.callback(eagerx::Tick{n}, in, out, left_simulator_);
        new_observation = LeftThetaDotObservationProcessor::convert(raw_observation);
        hooks.on_message(channel::left_theta_dot_observation, n, new_observation);
      }
    }
    if ((due & k15Hz) != 0) {
      const eagerx::Seq n = n15Hz_ - 1;
      // right/x: OdeOutput
      {
        const RightXIo::Inputs in{.tick = {engine_tick_, n60Hz_}};
        RightXIo::Outputs out{.observation = right_x_observation_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("right/x", RightXIo::Rate{}, n, in);
        }
        right_x_.callback(eagerx::Tick{n}, in, out, right_simulator_);
        hooks.on_message(channel::right_x_observation, n, right_x_observation_[0]);
      }
      // right/theta: FloatOutput
      {
        const RightThetaIo::Inputs in{.observation_array = {right_x_observation_, n15Hz_}};
        auto& new_observation = right_theta_observation_[eagerx::ring_position<2>(n)];
        RightThetaIo::Outputs out{.observation = new_observation};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("right/theta", RightThetaIo::Rate{}, n, in);
        }
        right_theta_.callback(eagerx::Tick{n}, in, out, right_simulator_);
        hooks.on_message(channel::right_theta_observation, n, new_observation);
      }
    }
    if ((due & k10Hz) != 0) {
      const eagerx::Seq n = n10Hz_ - 1;
      // left/u_applied: ActionApplied
      {
        const LeftUAppliedIo::Inputs in{.tick = {engine_tick_, n60Hz_},
                                        .action_applied = {left_u_action_applied_, n30Hz_ - 1}};
        auto& new_action_applied = left_u_applied_action_applied_[eagerx::ring_position<2>(n)];
        LeftUAppliedIo::Outputs out{.action_applied = new_action_applied};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("left/u_applied", LeftUAppliedIo::Rate{}, n, in);
        }
        left_u_applied_.callback(eagerx::Tick{n}, in, out, left_simulator_);
        hooks.on_message(channel::left_u_applied_action_applied, n, new_action_applied);
      }
    }
  }

  // From the environment on: everything that needs its action.
  template <class Mask>
  void run_after_action(const Mask due) {
    if ((due & k20Hz) != 0) {
      const eagerx::Seq n = n20Hz_ - 1;
      // slow: ButterworthFilter
      {
        const SlowIo::Inputs in{.signal = {action_voltage_, slow_signal_cursor_.take()}};
        auto& new_filtered = slow_filtered_[eagerx::ring_position<2>(n)];
        SlowIo::Outputs out{.filtered = new_filtered};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("slow", SlowIo::Rate{}, n, in);
        }
        slow_.callback(eagerx::Tick{n}, in, out);
        hooks.on_message(channel::slow_filtered, n, new_filtered);
      }
    }
    if ((due & k30Hz) != 0) {
      const eagerx::Seq n = n30Hz_ - 1;
      // left/u: OdeInput
      {
        const LeftUIo::Inputs in{.tick = {engine_tick_, n60Hz_},
                                 .action = {slow_filtered_, n20Hz_}};
        LeftUIo::Outputs out{.action_applied = left_u_action_applied_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("left/u", LeftUIo::Rate{}, n, in);
        }
        left_u_.callback(eagerx::Tick{n}, in, out, left_simulator_);
        hooks.on_message(channel::left_u_action_applied, n, left_u_action_applied_[0]);
      }
    }
  }

  // A slot without the environment.
  template <class Mask>
  void run_slot(const Mask due) {
    run_before_action(due);
    run_after_action(due);
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
    make_safe();
    eagerx::tell_memory_fault();
    n10Hz_ = 0;
    return at_rest();
  }
  std::uint32_t memory_faults_ = 0;

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
  eagerx::DelayCursor<1, 2> slow_signal_cursor_{};         // slow.signal
  // right/u_applied.action_applied
  eagerx::SkipCursor<2, 3, 1> right_u_applied_action_applied_cursor_{};

  // Messages: as many of each as its readers need.
  eagerx::Array<float, 1> action_voltage_[4]{};  // slow.signal needs 3
  eagerx::Array<float, 1> action_push_[4]{};     // fast.signal needs 3
  std::int64_t engine_tick_[1]{};
  eagerx::Array<float, 1> slow_filtered_[2]{};  // left.u needs 2
  eagerx::Array<float, 1> fast_filtered_[4]{};  // observations.recent needs 4
  eagerx::Array<float, 2> left_x_observation_[1]{};
  float left_theta_observation_[1]{};
  float left_theta_dot_observation_[8]{};  // observations.speeds needs 6
  eagerx::Array<float, 1> left_u_action_applied_[1]{};
  eagerx::Array<float, 1> left_u_applied_action_applied_[2]{};  // observations.applied needs 2
  eagerx::Array<float, 2> right_x_observation_[1]{};
  float right_theta_observation_[2]{};  // observations.other needs 2
  eagerx::Array<float, 1> right_u_action_applied_[1]{};
  eagerx::Array<float, 1> right_u_applied_action_applied_[1]{};
  eagerx::Array<float, 2> observation_angle_[2]{};  // observations.angle needs 2
  eagerx::Array<float, 1> right_u_action_[1]{};

  bool warm_ = false;     // whether the engine was started
  bool started_ = false;  // whether there was a reset at all

  // Simulators, engine and nodes.
  LeftSimulator left_simulator_{};
  RightSimulator right_simulator_{};
  eagerx::models::OdeEngine<EngineIo> engine_{};
  eagerx::models::ButterworthFilter<FastIo> fast_{};
  eagerx::models::ActionApplied<RightUAppliedIo> right_u_applied_{};
  eagerx::models::OdeOutput<LeftXIo> left_x_{};
  eagerx::models::FloatOutput<LeftThetaIo> left_theta_{};
  eagerx::models::OdeInput<RightUIo> right_u_{};
  eagerx::models::FloatOutput<LeftThetaDotIo> left_theta_dot_{};
  eagerx::models::OdeOutput<RightXIo> right_x_{};
  eagerx::models::FloatOutput<RightThetaIo> right_theta_{};
  eagerx::models::ActionApplied<LeftUAppliedIo> left_u_applied_{};
  eagerx::models::ButterworthFilter<SlowIo> slow_{};
  eagerx::models::OdeInput<LeftUIo> left_u_{};
};

}  // namespace graphs::multi_rate

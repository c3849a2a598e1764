// Graph `pendulum_swing_up` on OdeEngine: its memory, its schedule, one step.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
//
// Every node appears once, in data-flow order, under the bit of its rate. A slot is an instant at
// which at least one rate is due; a step is one slot.
#pragma once

#include <cstdint>
#include <eagerx/engine.hpp>
#include <eagerx/guard.hpp>
#include <eagerx/hooks.hpp>
#include <eagerx/render.hpp>
#include <eagerx/schedule.hpp>

#include "pendulum_swing_up/io.hpp"
#include "pendulum_swing_up/limits.hpp"

namespace graphs::pendulum_swing_up {

/// The whole graph in one object: no heap, all zero until the first reset. A step is 1/30 s.
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
      eagerx::start(engine_, pendulum_simulator_);
    }
  }
  /// At the end of a run: an engine of real hardware lets it come to rest.
  void stop() {
    if (eagerx::runs_engine(hooks)) {
      eagerx::stop(engine_, pendulum_simulator_);
    }
  }
  /// Outside of a step, when what decides is silent or about to stop: an engine of real hardware
  /// applies its safe actions.
  void make_safe() {
    if (eagerx::runs_engine(hooks)) {
      eagerx::make_safe(engine_, pendulum_simulator_);
    }
  }
  /// In a copy of this program, when it was killed: opens hardware anew and makes it safe, as its
  /// actuators declare it.
  void take_over() {
    warm_up();
    pendulum_u_applied_.reset({}, pendulum_simulator_);
    pendulum_x_.reset({}, pendulum_simulator_);
    pendulum_theta_.reset({}, pendulum_simulator_);
    pendulum_theta_dot_.reset({}, pendulum_simulator_);
    smooth_.reset({});
    pendulum_u_.reset({}, pendulum_simulator_);
    stop();
  }
  /// Whether the engine acts on the world itself.
  [[nodiscard]] bool is_real() const { return eagerx::is_real(engine_, pendulum_simulator_); }
  /// f(name, count) for what engine, objects and nodes count besides messages. A name is valid
  /// during its call.
  template <class F>
  void for_each_count(F&& f) const {
    eagerx::for_each_count(f, engine_, pendulum_simulator_);
  }

  /// Starts an episode; the observation of its tick 0. What `states` leaves empty stays as it is.
  Observation reset(const States& states) & {
    n30Hz_ = 0;
    guard.reset();
    if (!started_) {
      warm_up();
      started_ = true;
    }
    if (eagerx::runs_engine(hooks)) {
      if (states.pendulum_model_state) {
        PendulumModelState::reset(*states.pendulum_model_state, pendulum_simulator_);
      }
      if (states.pendulum_mass) {
        PendulumMass::reset(*states.pendulum_mass, pendulum_simulator_);
      }
      if (states.pendulum_length) {
        PendulumLength::reset(*states.pendulum_length, pendulum_simulator_);
      }
      if (states.pendulum_max_speed) {
        PendulumMaxSpeed::reset(*states.pendulum_max_speed, pendulum_simulator_);
      }
      eagerx::reset_engine(engine_, EngineIo::States{}, pendulum_simulator_);
    }
    pendulum_u_applied_.reset({}, pendulum_simulator_);
    pendulum_x_.reset({}, pendulum_simulator_);
    pendulum_theta_.reset({}, pendulum_simulator_);
    if constexpr (eagerx::can_draw<Hooks>) {
      drawing_.pendulum_scene_.reset({}, pendulum_simulator_);
    }
    pendulum_theta_dot_.reset({}, pendulum_simulator_);
    if constexpr (eagerx::can_draw<Hooks>) {
      drawing_.render_.reset({});
    }
    smooth_.reset({});
    pendulum_u_.reset({}, pendulum_simulator_);
    run_before_action(eagerx::Constant<k30Hz>{});
    return observe();
  }

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
    if (n30Hz_ == 0) [[unlikely]] {
      return before_reset();
    }
    // actions.voltage
    action_voltage_[0] = action.voltage;
    hooks.on_message(channel::environment_voltage, n30Hz_ - 1, action_voltage_[0]);
    run_after_action(eagerx::Constant<k30Hz>{});
    run_before_action(eagerx::Constant<k30Hz>{});
    return observe();
  }

  /// Steps before the first reset. They do nothing: neither the engine nor a node runs.
  [[nodiscard]] std::uint32_t steps_before_reset() const { return steps_before_reset_; }

 private:
  using Due = std::uint32_t;
  static constexpr Due k30Hz = Due{1} << 0U;

  [[gnu::noinline, gnu::cold]] Observation before_reset() {
    ++steps_before_reset_;
    return at_rest();
  }
  Observation at_rest() {
    return Observation{.angle = {observation_angle_, 0, 0},
                       .theta_dot = {pendulum_theta_dot_observation_, 0, 0}};
  }

  // Up to the environment: everything that does not need the action of the same instant.
  template <class Mask>
  void run_before_action([[maybe_unused]] const Mask due) {
    ++n30Hz_;
    if constexpr (eagerx::waits_for_slots<Hooks>) {
      hooks.wait_for_slot(eagerx::Rate<30>{}, n30Hz_ - 1);
    }
    {
      const eagerx::Seq n = n30Hz_ - 1;
      // engine: OdeEngine
      {
        if (n > 0 && eagerx::runs_engine(hooks)) {
          engine_.callback(eagerx::Tick{n}, pendulum_simulator_);
        }
        engine_tick_[0] = static_cast<std::int64_t>(n);
        hooks.on_message(channel::engine_tick, n, engine_tick_[0]);
        if constexpr (eagerx::sees_simulators<Hooks>) {
          hooks.on_simulator("pendulum", n, pendulum_simulator_);
        }
      }
      // pendulum/u_applied: ActionApplied
      {
        const PendulumUAppliedIo::Inputs in{
            .tick = {engine_tick_, n30Hz_},
            .action_applied = {pendulum_u_action_applied_, n30Hz_ - 1}};
        PendulumUAppliedIo::Outputs out{.action_applied = pendulum_u_applied_action_applied_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("pendulum/u_applied", PendulumUAppliedIo::Rate{}, n, in);
        }
        pendulum_u_applied_.callback(eagerx::Tick{n}, in, out, pendulum_simulator_);
        hooks.on_message(channel::pendulum_u_applied_action_applied, n,
                         pendulum_u_applied_action_applied_[0]);
      }
      // pendulum/x: OdeOutput
      {
        const PendulumXIo::Inputs in{.tick = {engine_tick_, n30Hz_}};
        PendulumXIo::Outputs out{.observation = pendulum_x_observation_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("pendulum/x", PendulumXIo::Rate{}, n, in);
        }
        pendulum_x_.callback(eagerx::Tick{n}, in, out, pendulum_simulator_);
        hooks.on_message(channel::pendulum_x_observation, n, pendulum_x_observation_[0]);
      }
      // pendulum/theta: FloatOutput
      {
        const PendulumThetaIo::Inputs in{.observation_array = {pendulum_x_observation_, n30Hz_}};
        PendulumThetaIo::Outputs out{.observation = pendulum_theta_observation_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("pendulum/theta", PendulumThetaIo::Rate{}, n, in);
        }
        pendulum_theta_.callback(eagerx::Tick{n}, in, out, pendulum_simulator_);
        hooks.on_message(channel::pendulum_theta_observation, n, pendulum_theta_observation_[0]);
        observation_angle_[0] = ObservationAngleProcessor::convert(pendulum_theta_observation_[0]);
      }
      // pendulum/scene: PendulumDrawing
      if constexpr (eagerx::can_draw<Hooks>) {
        if (hooks.draws()) {
          const PendulumSceneIo::Inputs in{.angle = {pendulum_theta_observation_, n30Hz_}};
          PendulumSceneIo::Outputs out{.scene = drawing_.pendulum_scene_scene_[0]};
          if constexpr (eagerx::sees_inputs<Hooks>) {
            hooks.on_inputs("pendulum/scene", PendulumSceneIo::Rate{}, n, in);
          }
          drawing_.pendulum_scene_.callback(eagerx::Tick{n}, in, out, pendulum_simulator_);
        }
      }
      // pendulum/theta_dot: FloatOutput
      {
        const PendulumThetaDotIo::Inputs in{.observation_array = {pendulum_x_observation_, n30Hz_}};
        PendulumThetaDotIo::Outputs out{.observation = pendulum_theta_dot_observation_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("pendulum/theta_dot", PendulumThetaDotIo::Rate{}, n, in);
        }
        pendulum_theta_dot_.callback(eagerx::Tick{n}, in, out, pendulum_simulator_);
        hooks.on_message(channel::pendulum_theta_dot_observation, n,
                         pendulum_theta_dot_observation_[0]);
      }
      // render: Render
      if constexpr (eagerx::can_draw<Hooks>) {
        if (hooks.draws()) {
          const RenderIo::Inputs in{.source = {drawing_.pendulum_scene_scene_, n30Hz_}};
          RenderIo::Outputs out{};
          if constexpr (eagerx::sees_inputs<Hooks>) {
            hooks.on_inputs("render", RenderIo::Rate{}, n, in);
          }
          drawing_.render_.callback(eagerx::Tick{n}, in, out, hooks);
        }
      }
    }
  }

  // From the environment on: everything that needs its action.
  template <class Mask>
  void run_after_action([[maybe_unused]] const Mask due) {
    {
      const eagerx::Seq n = n30Hz_ - 1;
      // smooth: ButterworthFilter
      {
        const SmoothIo::Inputs in{.signal = {action_voltage_, n30Hz_}};
        SmoothIo::Outputs out{.filtered = smooth_filtered_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("smooth", SmoothIo::Rate{}, n, in);
        }
        smooth_.callback(eagerx::Tick{n}, in, out);
        hooks.on_message(channel::smooth_filtered, n, smooth_filtered_[0]);
      }
      // pendulum/u: OdeInput
      {
        const PendulumUIo::Inputs in{.tick = {engine_tick_, n30Hz_},
                                     .action = {smooth_filtered_, n30Hz_}};
        PendulumUIo::Outputs out{.action_applied = pendulum_u_action_applied_[0]};
        if constexpr (eagerx::sees_inputs<Hooks>) {
          hooks.on_inputs("pendulum/u", PendulumUIo::Rate{}, n, in);
        }
        pendulum_u_.callback(eagerx::Tick{n}, in, out, pendulum_simulator_);
        hooks.on_message(channel::pendulum_u_action_applied, n, pendulum_u_action_applied_[0]);
      }
    }
  }

  // The observation of the environment.
  Observation observe() {
    const Observation observation{.angle = {observation_angle_, n30Hz_},
                                  .theta_dot = {pendulum_theta_dot_observation_, n30Hz_}};
    guard.see(observation);
    if constexpr (eagerx::sees_inputs<Hooks>) {
      hooks.on_inputs("environment", eagerx::Rate<30>{}, n30Hz_ - 1, observation);
    }
    return observation;
  }

  std::uint32_t steps_before_reset_ = 0;
  // Ticks so far, one counter a rate.
  eagerx::Seq n30Hz_ = 0;

  // Messages: as many of each as its readers need.
  eagerx::Array<float, 1> action_voltage_[1]{};
  std::int64_t engine_tick_[1]{};
  eagerx::Array<float, 1> smooth_filtered_[1]{};
  eagerx::Array<float, 2> pendulum_x_observation_[1]{};
  float pendulum_theta_observation_[1]{};
  float pendulum_theta_dot_observation_[1]{};
  eagerx::Array<float, 1> pendulum_u_action_applied_[1]{};
  eagerx::Array<float, 1> pendulum_u_applied_action_applied_[1]{};
  eagerx::Array<float, 2> observation_angle_[1]{};

  bool warm_ = false;     // whether the engine was started
  bool started_ = false;  // whether there was a reset at all

  // Simulators, engine and nodes.
  PendulumSimulator pendulum_simulator_{};
  eagerx::models::OdeEngine<EngineIo> engine_{};
  eagerx::models::ActionApplied<PendulumUAppliedIo> pendulum_u_applied_{};
  eagerx::models::OdeOutput<PendulumXIo> pendulum_x_{};
  eagerx::models::FloatOutput<PendulumThetaIo> pendulum_theta_{};
  eagerx::models::FloatOutput<PendulumThetaDotIo> pendulum_theta_dot_{};
  eagerx::models::ButterworthFilter<SmoothIo> smooth_{};
  eagerx::models::OdeInput<PendulumUIo> pendulum_u_{};

  // Only for pictures: empty in a program without them.
  struct Drawing {
    eagerx::Array<float, 24, 16> pendulum_scene_scene_[1]{};
    eagerx::models::PendulumDrawing<PendulumSceneIo> pendulum_scene_{};
    eagerx::Render<RenderIo> render_{};
  };
  [[no_unique_address]] eagerx::DrawingOf<Hooks, Drawing> drawing_{};
};

}  // namespace graphs::pendulum_swing_up

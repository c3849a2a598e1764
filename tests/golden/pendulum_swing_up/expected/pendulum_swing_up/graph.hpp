// Everything that a main loop needs to know of graph `pendulum_swing_up`.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <cstdint>
#include <eagerx/agent.hpp>
#include <eagerx/channel.hpp>
#include <eagerx/float_environment.hpp>
#include <eagerx/random.hpp>
#include <eagerx/space.hpp>

#include "pendulum_swing_up/limits.hpp"
#include "pendulum_swing_up/policy.hpp"
#include "pendulum_swing_up/program.hpp"

namespace graphs::pendulum_swing_up {

struct Graph : Limits {
  template <class Hooks>
  using Program = graphs::pendulum_swing_up::Program<Hooks>;
  using States = graphs::pendulum_swing_up::States;
  using Rate = eagerx::Rate<30>;  // of the environment

  static constexpr const char* kName = "pendulum_swing_up";
  static constexpr std::uint64_t kGraphHash = graphs::pendulum_swing_up::kGraphHash;
  static constexpr std::uint64_t kPolicyHash = graphs::pendulum_swing_up::kPolicyHash;
  static constexpr const char* kGenerator = graphs::pendulum_swing_up::kGenerator;
  static constexpr const char* kEngine = "OdeEngine";
  static constexpr const char* kDefaultAgent = "policy";
  static constexpr const char* kAgentCsv = "";
  static constexpr bool kHasPolicy = true;

  /// `render:`: pictures at this rate.
  static constexpr bool kRenders = true;
  using RenderRate = eagerx::Rate<30>;
  using Rendered = typename decltype(RenderIo::Inputs::source)::value_type;

  /// The published messages; the index is the channel of the trace.
  static constexpr eagerx::Channel kChannels[] = {
      {"engine/tick", "int64", 1, 30, 1, eagerx::Publisher::engine, "engine.tick"},
      {"environment/voltage", "float32", 1, 30, 1, eagerx::Publisher::environment,
       "actions.voltage", 0, 1},
      {"pendulum/theta/observation", "float32", 1, 30, 1, eagerx::Publisher::engine_node,
       "pendulum.theta", 1, 1},
      {"pendulum/theta_dot/observation", "float32", 1, 30, 1, eagerx::Publisher::engine_node,
       "pendulum.theta_dot", 2, 1},
      {"pendulum/u/action_applied", "float32", 1, 30, 1, eagerx::Publisher::engine_node,
       "pendulum/u.action_applied", 3, 1},
      {"pendulum/u_applied/action_applied", "float32", 1, 30, 1, eagerx::Publisher::engine_node,
       "pendulum/u_applied.action_applied", 4, 1},
      {"pendulum/x/observation", "float32", 2, 30, 1, eagerx::Publisher::engine_node,
       "pendulum/x.observation"},
      {"smooth/filtered", "float32", 1, 30, 1, eagerx::Publisher::node, "smooth.filtered", 5, 1},
  };
  /// Shapes of the published messages that are not one number.
  static constexpr eagerx::ChannelShape kShapes[] = {
      {1, "1"},  // environment/voltage
      {4, "1"},  // pendulum/u/action_applied
      {5, "1"},  // pendulum/u_applied/action_applied
      {6, "2"},  // pendulum/x/observation
      {7, "1"},  // smooth/filtered
  };
  /// Bounds of the published messages, where they have some.
  static constexpr eagerx::Bounds kBounds[] = {
      {-2.0, 2.0},      // environment/voltage
      {-999.0, 999.0},  // pendulum/theta/observation
      {-999.0, 999.0},  // pendulum/theta_dot/observation
      {-2.0, 2.0},      // pendulum/u/action_applied
      {-2.0, 2.0},      // pendulum/u_applied/action_applied
      {-2.0, 2.0},      // smooth/filtered
  };

  /// The range that pendulum.model_state is sampled from
  static constexpr eagerx::Space<eagerx::Array<float, 2>> kStatePendulumModelState{
      .low = {{-3.14F, -9.0F}}, .high = {{3.14F, 9.0F}}};

  /// The randomised states of an episode: a function of the key and of nothing else.
  [[nodiscard]] static States sample(eagerx::EpisodeKey key) {
    States states;
    {  // pendulum/model_state
      eagerx::Random random(key, eagerx::entity_id("pendulum/model_state"));
      states.pendulum_model_state = kStatePendulumModelState.sample(random);
    }
    {  // pendulum/mass
      states.pendulum_mass = float{0.0358F};
    }
    {  // pendulum/length
      states.pendulum_length = float{0.1158F};
    }
    {  // pendulum/max_speed
      states.pendulum_max_speed = float{22.0F};
    }
    return states;
  }

  /// f(name, member of States, space) for each state that is sampled from a range.
  template <class F>
  static void for_each_range(F&& f) {
    f("pendulum.model_state", &States::pendulum_model_state, kStatePendulumModelState);
  }

  /// f(name, what its samples are called, member of States, space) for each state.
  template <class F>
  static void for_each_state(F&& f) {
    f("pendulum.model_state", "pendulum/model_state", &States::pendulum_model_state,
      eagerx::Space<eagerx::Array<float, 2>>{.low = {{-3.14F, -9.0F}}, .high = {{3.14F, 9.0F}}});
    f("pendulum.mass", "pendulum/mass", &States::pendulum_mass,
      eagerx::Space<float>{.low = 0.01F, .high = 0.07F});
    f("pendulum.length", "pendulum/length", &States::pendulum_length,
      eagerx::Space<float>{.low = 0.04F, .high = 0.2F});
    f("pendulum.max_speed", "pendulum/max_speed", &States::pendulum_max_speed,
      eagerx::Space<float>{.low = 22.0F, .high = 22.0F});
  }

  /// The action that does nothing.
  [[nodiscard]] static Action zero() { return Action{}; }

  /// An action sampled uniformly from the spaces of the actions.
  [[nodiscard]] static Action random(eagerx::EpisodeKey key, eagerx::Seq step) {
    auto random = eagerx::Random::of_step(key, eagerx::entity_id("agent"), step, 2U);
    return {.voltage = kActionVoltage.sample(random)};
  }

  /// The trained policy's action: swing_up.onnx
  [[nodiscard]] static Action policy(const Observation& observation) {
    float input[policy::kInputs];
    float output[policy::kOutputs];
    std::size_t in = 0;
    eagerx::flatten(observation.angle, input, in);
    eagerx::flatten(observation.theta_dot, input, in);
    policy::evaluate(input, output);
    Action action;
    std::size_t out = 0;
    // squashed policy: from -1…1 to the action's bounds, as SB3's predict() does
    action.voltage =
        eagerx::unscaled(eagerx::unflatten<eagerx::Array<float, 1>>(output, out), kActionVoltage);
    return action;
  }

  /// True if this machine's answers of policies are those of the generator, to the bit.
  static constexpr std::size_t kSelfTestRows = 8;
  [[nodiscard]] static bool policies_answer() { return policy::self_test(); }
  /// True if also the calling thread's processor keeps denormal numbers and rounds to the nearest.
  [[nodiscard]] static bool self_test() {
    return eagerx::calculates_as_everywhere() && policies_answer();
  }
};

}  // namespace graphs::pendulum_swing_up

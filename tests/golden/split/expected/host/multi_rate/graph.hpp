// Everything that a main loop needs to know of graph `multi_rate`.
// Made by eagerx-gen 1.0.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <cstdint>
#include <eagerx/channel.hpp>
#include <eagerx/float_environment.hpp>
#include <eagerx/random.hpp>
#include <eagerx/sample.hpp>
#include <eagerx/space.hpp>

#include "multi_rate/limits.hpp"
#include "multi_rate/program.hpp"

namespace graphs::multi_rate {

struct Graph : Limits {
  template <class Hooks, class Link>
  using Program = graphs::multi_rate::Program<Hooks, Link>;
  /// The links to the other programs of this graph.
  struct Link {
    static constexpr bool kPartDecides = true;
    /// By most bytes of a frame's payload, there and back, and exchanges in flight if these are
    /// several.
    template <class Port>
    using Star = eagerx::link::Star<eagerx::link::HostLink<Port, 36, 16>>;
    static constexpr eagerx::link::PartFacts kParts[] = {
        {"board", "mps2-an386", "",
         eagerx::link::hash_of_part(graphs::multi_rate::kGraphHash, "board")},
    };
  };
  using States = graphs::multi_rate::States;
  using Rate = eagerx::Rate<10>;  // of the environment

  static constexpr const char* kName = "multi_rate";
  static constexpr std::uint64_t kGraphHash = graphs::multi_rate::kGraphHash;
  static constexpr std::uint64_t kPolicyHash = graphs::multi_rate::kPolicyHash;
  static constexpr const char* kGenerator = graphs::multi_rate::kGenerator;
  static constexpr const char* kEngine = "OdeEngine";
  static constexpr const char* kDefaultAgent = "random";
  static constexpr const char* kAgentCsv = "";
  static constexpr bool kHasPolicy = false;

  /// The published messages; the index is the channel of the trace.
  static constexpr eagerx::Channel kChannels[] = {
      {"engine/tick", "int64", 1, 60, 1, eagerx::Publisher::engine, "engine.tick"},
      {"environment/push", "float32", 1, 10, 1, eagerx::Publisher::environment, "actions.push", 0,
       1},
      {"environment/voltage", "float32", 1, 10, 1, eagerx::Publisher::environment,
       "actions.voltage", 1, 1},
      {"fast/filtered", "float32", 1, 30, 1, eagerx::Publisher::node, "fast.filtered", 2, 1},
      {"left/theta/observation", "float32", 1, 20, 1, eagerx::Publisher::engine_node, "left.theta",
       3, 1},
      {"left/theta_dot/observation", "float32", 1, 30, 1, eagerx::Publisher::engine_node,
       "left.theta_dot", 4, 1},
      {"left/u/action_applied", "float32", 1, 30, 1, eagerx::Publisher::engine_node,
       "left/u.action_applied", 5, 1},
      {"left/u_applied/action_applied", "float32", 1, 10, 1, eagerx::Publisher::engine_node,
       "left.u_applied", 6, 1},
      {"left/x/observation", "float32", 2, 20, 1, eagerx::Publisher::engine_node,
       "left/x.observation"},
      {"right/theta/observation", "float32", 1, 15, 1, eagerx::Publisher::engine_node,
       "right.theta", 7, 1},
      {"right/u/action_applied", "float32", 1, 20, 1, eagerx::Publisher::engine_node,
       "right/u.action_applied", 8, 1},
      {"right/u_applied/action_applied", "float32", 1, 30, 1, eagerx::Publisher::engine_node,
       "right/u_applied.action_applied", 9, 1},
      {"right/x/observation", "float32", 2, 15, 1, eagerx::Publisher::engine_node,
       "right/x.observation"},
      {"slow/filtered", "float32", 1, 20, 1, eagerx::Publisher::node, "slow.filtered", 10, 1},
  };
  /// Shapes of the published messages that are not one number.
  static constexpr eagerx::ChannelShape kShapes[] = {
      {1, "1"},   // environment/push
      {2, "1"},   // environment/voltage
      {3, "1"},   // fast/filtered
      {6, "1"},   // left/u/action_applied
      {7, "1"},   // left/u_applied/action_applied
      {8, "2"},   // left/x/observation
      {10, "1"},  // right/u/action_applied
      {11, "1"},  // right/u_applied/action_applied
      {12, "2"},  // right/x/observation
      {13, "1"},  // slow/filtered
  };
  /// Bounds of the published messages, where they have some.
  static constexpr eagerx::Bounds kBounds[] = {
      {-1.0, 1.0},      // environment/push
      {-2.0, 2.0},      // environment/voltage
      {-1.0, 1.0},      // fast/filtered
      {-999.0, 999.0},  // left/theta/observation
      {-999.0, 999.0},  // left/theta_dot/observation
      {-2.0, 2.0},      // left/u/action_applied
      {-2.0, 2.0},      // left/u_applied/action_applied
      {-999.0, 999.0},  // right/theta/observation
      {-2.0, 2.0},      // right/u/action_applied
      {-2.0, 2.0},      // right/u_applied/action_applied
      {-2.0, 2.0},      // slow/filtered
  };

  /// The range that left.model_state is sampled from
  static constexpr eagerx::Space<eagerx::Array<float, 2>> kStateLeftModelState{
      .low = {{-3.14F, -9.0F}}, .high = {{3.14F, 9.0F}}};
  /// The range that left.mass is sampled from
  static constexpr eagerx::Space<float> kStateLeftMass{.low = 0.01F, .high = 0.07F};
  /// The range that right.model_state is sampled from
  static constexpr eagerx::Space<eagerx::Array<float, 2>> kStateRightModelState{
      .low = {{-1.0F, -2.0F}}, .high = {{1.0F, 2.0F}}};

  /// The randomised states of an episode: a function of the key and of nothing else.
  [[nodiscard]] static States sample(eagerx::EpisodeKey key) {
    States states;
    {  // left/model_state
      eagerx::Random random(key, eagerx::entity_id("left/model_state"));
      constexpr eagerx::Array<float, 2> kMean{{0.5F, 0.0F}};
      constexpr eagerx::Array<float, 2> kStd{{0.1F, 0.2F}};
      states.left_model_state =
          kStateLeftModelState.clipped(eagerx::sample_normal(random, kMean, kStd));
    }
    {  // left/mass
      eagerx::Random random(key, eagerx::entity_id("left/mass"));
      states.left_mass =
          eagerx::sample_log_uniform(random, kStateLeftMass.low, kStateLeftMass.high);
    }
    {  // left/length
      eagerx::Random random(key, eagerx::entity_id("left/length"));
      constexpr float kChoices[] = {0.05F, 0.1F, 0.2F};
      states.left_length = eagerx::sample_choice(random, kChoices);
    }
    {  // right/model_state
      eagerx::Random random(key, eagerx::entity_id("right/model_state"));
      states.right_model_state = kStateRightModelState.sample(random);
    }
    {  // right/max_speed
      states.right_max_speed = float{22.0F};
    }
    return states;
  }

  /// f(name, member of States, space) for each state that is sampled from a range.
  template <class F>
  static void for_each_range(F&& f) {
    f("left.model_state", &States::left_model_state, kStateLeftModelState);
    f("left.mass", &States::left_mass, kStateLeftMass);
    f("right.model_state", &States::right_model_state, kStateRightModelState);
  }

  /// f(name, what its samples are called, member of States, space) for each state.
  template <class F>
  static void for_each_state(F&& f) {
    f("left.model_state", "left/model_state", &States::left_model_state,
      eagerx::Space<eagerx::Array<float, 2>>{.low = {{-3.14F, -9.0F}}, .high = {{3.14F, 9.0F}}});
    f("left.mass", "left/mass", &States::left_mass,
      eagerx::Space<float>{.low = 0.01F, .high = 0.07F});
    f("left.length", "left/length", &States::left_length,
      eagerx::Space<float>{.low = 0.04F, .high = 0.2F});
    f("right.model_state", "right/model_state", &States::right_model_state,
      eagerx::Space<eagerx::Array<float, 2>>{.low = {{-3.14F, -9.0F}}, .high = {{3.14F, 9.0F}}});
    f("right.max_speed", "right/max_speed", &States::right_max_speed,
      eagerx::Space<float>{.low = 22.0F, .high = 22.0F});
    f("right.length", "right/length", &States::right_length,
      eagerx::Space<float>{.low = 0.04F, .high = 0.2F});
  }

  /// The action that does nothing.
  [[nodiscard]] static Action zero() { return Action{}; }

  /// An action sampled uniformly from the spaces of the actions.
  [[nodiscard]] static Action random(eagerx::EpisodeKey key, eagerx::Seq step) {
    auto random = eagerx::Random::of_step(key, eagerx::entity_id("agent"), step, 4U);
    return {.voltage = kActionVoltage.sample(random), .push = kActionPush.sample(random)};
  }

  /// True if this machine's answers of policies are those of the generator, to the bit.
  static constexpr std::size_t kSelfTestRows = 0;
  [[nodiscard]] static bool policies_answer() { return true; }
  /// True if also the calling thread's processor keeps denormal numbers and rounds to the nearest.
  [[nodiscard]] static bool self_test() {
    return eagerx::calculates_as_everywhere() && policies_answer();
  }
};

}  // namespace graphs::multi_rate

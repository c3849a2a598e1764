// Everything that a main loop needs to know of graph `multi_rate`.
// Made by eagerx-gen 0.1.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <cstdint>
#include <limits>

#include <eagerx/agent.hpp>
#include <eagerx/channel.hpp>
#include <eagerx/draw.hpp>
#include <eagerx/random.hpp>
#include <eagerx/safety.hpp>
#include <eagerx/space.hpp>

#include "multi_rate/program.hpp"

namespace graphs::multi_rate {

struct Graph {
  template <class Trace, class Link>
  using Program = graphs::multi_rate::Program<Trace, Link>;
  /// The link between the two programs of this graph.
  struct Link {
    static constexpr std::uint64_t kGraph = 0xafdc5f69494de059U;  // of the sources of both
    static constexpr std::size_t kToBoard = 36;  // most bytes of a frame's payload
    static constexpr std::size_t kToHost = 16;
    static constexpr bool kBoardDecides = true;
    static constexpr const char* kBoard = "mps2-an386";
  };
  using Action = graphs::multi_rate::Action;
  using Observation = graphs::multi_rate::Observation;
  using States = graphs::multi_rate::States;
  using Rate = eagerx::Rate<10>;  // of the environment

  static constexpr const char* kName = "multi_rate";
  static constexpr const char* kEngine = "OdeEngine";
  static constexpr const char* kDefaultAgent = "random";
  static constexpr const char* kAgentCsv = "";
  static constexpr bool kHasPolicy = false;

  /// The published messages; the index is the channel of the trace.
  static constexpr eagerx::Channel kChannels[] = {
      {"engine/tick", "int64", 1, 60, 1, eagerx::Publisher::engine},
      {"environment/push", "float32", 1, 10, 1, eagerx::Publisher::environment},
      {"environment/voltage", "float32", 1, 10, 1, eagerx::Publisher::environment},
      {"fast/filtered", "float32", 1, 30, 1, eagerx::Publisher::node},
      {"left/theta/observation", "float32", 1, 20, 1, eagerx::Publisher::engine_node},
      {"left/theta_dot/observation", "float32", 1, 30, 1, eagerx::Publisher::engine_node},
      {"left/u/action_applied", "float32", 1, 30, 1, eagerx::Publisher::engine_node},
      {"left/u_applied/action_applied", "float32", 1, 10, 1, eagerx::Publisher::engine_node},
      {"left/x/observation", "float32", 2, 20, 1, eagerx::Publisher::engine_node},
      {"right/theta/observation", "float32", 1, 15, 1, eagerx::Publisher::engine_node},
      {"right/u/action_applied", "float32", 1, 20, 1, eagerx::Publisher::engine_node},
      {"right/u_applied/action_applied", "float32", 1, 30, 1, eagerx::Publisher::engine_node},
      {"right/x/observation", "float32", 2, 15, 1, eagerx::Publisher::engine_node},
      {"slow/filtered", "float32", 1, 20, 1, eagerx::Publisher::node},
  };

  /// actions.voltage, graph.yaml:46:3
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kActionVoltage{
      .low = {{-2.0F}}, .high = {{2.0F}}};
  /// actions.push, graph.yaml:47:3
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kActionPush{
      .low = {{-1.0F}}, .high = {{1.0F}}};
  /// observations.angle, graph.yaml:55:28
  static constexpr eagerx::Space<eagerx::Array<float, 2>> kObservationAngle{
      .low = {{-1.0F, -1.0F}}, .high = {{1.0F, 1.0F}}};
  /// observations.speeds, graph.yaml:56:32
  static constexpr eagerx::Space<float> kObservationSpeeds{.low = -999.0F, .high = 999.0F};
  /// observations.recent, graph.yaml:57:31
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kObservationRecent{
      .low = {{-1.0F}}, .high = {{1.0F}}};
  /// observations.applied, graph.yaml:58:32
  static constexpr eagerx::Space<eagerx::Array<float, 1>> kObservationApplied{
      .low = {{-2.0F}}, .high = {{2.0F}}};
  /// observations.other, graph.yaml:59:29
  static constexpr eagerx::Space<float> kObservationOther{.low = -999.0F, .high = 999.0F};

  /// The randomised states of an episode: a function of the key and of nothing else.
  static States draw(eagerx::EpisodeKey /*key*/) {
    States states;
    return states;
  }

  /// f(name, member of States, space) for each state that is drawn from a range.
  template <class F>
  static void for_each_range(F&& /*f*/) {}

  /// The action that does nothing.
  static Action zero() { return Action{}; }

  /// When the safe action takes the agent's place.
  static constexpr eagerx::Safety kSafety{.declared = false,
                                          .late = 1,
                                          .max_lateness_ns = 100000000,
                                          .link_timeout_ns = 10000000,
                                          .missed = 2,
                                          .recover = 3,
                                          .clips = true,
                                          .holds = false};
  /// The safe action.
  static Action safe() { return {{{0.0F}}, {{0.0F}}}; }

  /// An action drawn uniformly from the spaces of the actions.
  static Action random(eagerx::EpisodeKey key, eagerx::Seq step) {
    auto random = eagerx::Random::of_step(key, eagerx::entity_id("agent"), step, 4U);
    return {kActionVoltage.sample(random), kActionPush.sample(random)};
  }

  /// True if this machine's answers of policies are those of the generator, to the bit.
  static constexpr std::size_t kSelfTestRows = 0;
  static bool self_test() { return true; }

  /// f(name, message, space) for each action.
  template <class F>
  static void for_each_action(Action& action, F&& f) {
    f("voltage", action.voltage, kActionVoltage);
    f("push", action.push, kActionPush);
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

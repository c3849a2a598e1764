// Everything that a main loop needs to know of graph `multi_rate`.
// Made by eagerx-gen 0.1.0 from graph.yaml. Do not edit: change the graph and generate again.
#pragma once

#include <cstdint>
#include <limits>

#include <eagerx/agent.hpp>
#include <eagerx/channel.hpp>
#include <eagerx/draw.hpp>
#include <eagerx/random.hpp>
#include <eagerx/space.hpp>

#include "multi_rate/program.hpp"

namespace graphs::multi_rate {

struct Graph : Limits {
  template <class Trace, class Link>
  using Program = graphs::multi_rate::Program<Trace, Link>;
  /// The link between the two programs of this graph.
  struct Link {
    static constexpr std::uint64_t kGraph = 0x7631e768a02091d7U;  // of the sources of both
    static constexpr std::size_t kToBoard = 36;  // most bytes of a frame's payload
    static constexpr std::size_t kToHost = 16;
    static constexpr bool kBoardDecides = true;
    static constexpr const char* kBoard = "mps2-an386";
  };
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

  /// An action drawn uniformly from the spaces of the actions.
  static Action random(eagerx::EpisodeKey key, eagerx::Seq step) {
    auto random = eagerx::Random::of_step(key, eagerx::entity_id("agent"), step, 4U);
    return {kActionVoltage.sample(random), kActionPush.sample(random)};
  }

  /// True if this machine's answers of policies are those of the generator, to the bit.
  static constexpr std::size_t kSelfTestRows = 0;
  static bool self_test() { return true; }
};

}  // namespace graphs::multi_rate

// The board's half of a split graph: follows the host's commands over the link until the end of the
// run.
#pragma once

#include <cstdint>
#include <eagerx/float_environment.hpp>
#include <eagerx/hooks.hpp>
#include <eagerx/link/board.hpp>
#include <eagerx/version.hpp>
#include <new>
#include <targets/common/run.hpp>

namespace eagerx::target {

/// The board's answer to the host instead of working.
inline constexpr std::uint8_t kPolicyDiffers = 1;
inline constexpr std::uint8_t kFloatsDiffer = 2;

/// 0 if the board calculates as everywhere.
template <class Graph>
std::uint8_t what_differs() {
  if (!calculates_as_everywhere()) return kFloatsDiffer;
  return Graph::policies_answer() ? 0 : kPolicyDiffers;
}

inline constexpr std::uint16_t kRuntimeVersion =
    static_cast<std::uint16_t>(kVersionMajor * 256 + kVersionMinor);

template <class Graph, class Port>
using BoardLinkOf =
    link::BoardLink<Port, Graph::Link::kToBoard, Graph::Link::kToHost, Graph::Link::kDepth>;
template <class Graph, class Port>
using BoardProgramOf = typename Graph::template Program<NoHooks, BoardLinkOf<Graph, Port>>;

/// Whether a board knows the agent `random`: one with a policy does without its 600 bytes.
template <class Graph>
inline constexpr bool board_knows_random = !Graph::kHasPolicy;

template <class Graph, class Program>
typename Graph::Action decide(Agent agent, EpisodeKey key, Seq step,
                              const typename Graph::Observation& observation, Program& program) {
  if constexpr (!board_knows_random<Graph>) {
    if (agent != Agent::policy) return Graph::zero();
  }
  return act<Graph>(board_knows_random<Graph> ? agent : Agent::policy, key, step, observation,
                    program);
}

/// Runs one episode after its reset. Returns true, with `command`, at a command other than a step,
/// or false when the session has ended.
template <class Graph, class Program, class Link>
bool run_steps(Program& program, Link& link, const link::Episode& episode, std::uint8_t& command) {
  typename Graph::Observation observation = program.reset(Graph::sample(episode.key));
  for (Seq step = 0; link.get(command); ++step) {
    const bool safe =
        Graph::kSafety.declared && command == static_cast<std::uint8_t>(link::Command::safe_step);
    if (!safe && command != static_cast<std::uint8_t>(link::Command::step)) return true;
    std::uint8_t late = 0;
    if (!link.get(late)) return false;
    typename Graph::Action action{};
    if constexpr (Graph::Link::kBoardDecides) {
      const auto agent = static_cast<Agent>(episode.agent);
      if (!safe) action = decide<Graph>(agent, episode.key, step, observation, program);
    }
    if (safe) {
      observation = step_safely<Graph>(program);
    } else {
      action = guarded(program, action, late);
      observation = apply(program, action);
    }
  }
  return false;
}

/// The counters of a session on the board that are not 0.
template <class Graph, class Program, class Link>
void report(const Program& program, Link& link, std::uint32_t stack_bytes) {
  link::Report{stack_bytes, link.damaged()}.put(link);
  const auto put = [&](const char* name, std::uint64_t count) {
    if (count > 0) link::put_count(link, name, count);
  };
  for_each_fault(program, put);
  link::end_counts(link);
}

/// Serves one host after the other, each with a fresh program. `stack_bytes()` is the maximum stack
/// depth so far, 0 if it is not measured. Returns when the line is closed: whether the last host
/// had finished.
template <class Graph, class Port, class StackBytes>
bool serve(BoardProgramOf<Graph, Port>& program, BoardLinkOf<Graph, Port>& link,
           StackBytes&& stack_bytes) {
  using Program = BoardProgramOf<Graph, Port>;
  link.identify({Graph::Link::kGraph, kRuntimeVersion}, what_differs<Graph>());
  bool has_finished = false;
  while (link.wait_for_host()) {
    has_finished = false;
    program.~Program();
    ::new (static_cast<void*>(&program)) Program{};
    program.connect(link);
    std::uint8_t command = 0;
    bool continues = link.get(command);
    while (continues) {
      if (command == static_cast<std::uint8_t>(link::Command::reset)) {
        link::Episode episode;
        has_finished = false;
        continues = episode.get(link) && run_steps<Graph>(program, link, episode, command);
      } else if (command == static_cast<std::uint8_t>(link::Command::finish)) {
        report<Graph>(program, link, stack_bytes());
        has_finished = true;
        continues = link.get(command);
      } else {
        break;  // no host of this graph says so
      }
    }
  }
  return has_finished;
}

}  // namespace eagerx::target

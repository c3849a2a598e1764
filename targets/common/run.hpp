// The loop of every target: episodes, steps and an agent. Linux and boards share it, so that two
// programs of one graph do the same things in the same order and end with the same trace hash.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>
#include <string_view>

namespace eagerx::target {

/// How much to run. The defaults hold on every target, see default_plan().
struct RunPlan {
  std::uint32_t episodes = 1;
  std::uint64_t steps = 300;  // of each episode
  std::uint64_t seed = 1;
  std::uint32_t environment = 0;  // one of many with this seed, each with numbers of its own
};

/// The outcome of a step of a graph without a task.
struct NoOutcome {
  template <class F>
  void for_each(F&& /*f*/) const {}
};
template <class Graph>
struct OutcomeOf {
  using Type = NoOutcome;
};
template <class Graph>
requires requires {
  Graph::kHasTask;
}
struct OutcomeOf<Graph> {
  using Type = typename Graph::Outcome;
};

/// The defaults of a program: the length of an episode is that of the graph's task, if it has one.
template <class Graph>
constexpr RunPlan default_plan() {
  RunPlan plan;
  if constexpr (requires { Graph::kHasTask; }) {
    if (Graph::kEpisodeSteps > 0) plan.steps = Graph::kEpisodeSteps;
  }
  return plan;
}

/// Where actions come from. `csv` exists on targets with files only. A target may have agents of
/// its own, which graphs do not name: their numbers begin at kAgents.
enum class Agent : std::uint8_t { policy, zero, random, csv };
inline constexpr std::uint8_t kAgents = 4;

/// The agent with this name in graphs and on command lines; false if there is none.
constexpr bool agent_of(std::string_view name, Agent& agent) {
  if (name == "policy") return agent = Agent::policy, true;
  if (name == "zero") return agent = Agent::zero, true;
  if (name == "random") return agent = Agent::random, true;
  if (name == "csv") return agent = Agent::csv, true;
  return false;
}

constexpr std::string_view name_of(Agent agent) {
  switch (agent) {
    case Agent::policy:
      return "policy";
    case Agent::zero:
      return "zero";
    case Agent::random:
      return "random";
    case Agent::csv:
      break;
  }
  return "csv";
}

/// The agent a graph was generated with.
template <class Graph>
constexpr Agent default_agent() {
  Agent agent = Agent::zero;
  agent_of(Graph::kDefaultAgent, agent);
  return agent;
}

/// The policy's action; its memory is in the program.
template <class Graph, class Program>
typename Graph::Action policy_action(const typename Graph::Observation& observation,
                                     Program& program) {
  if constexpr (requires { program.policy_memory; }) {
    return Graph::policy(observation, program.policy_memory);
  } else {
    return Graph::policy(observation);
  }
}

/// Action `step` (from 0) of an agent that needs nothing but the program itself.
template <class Graph, class Program>
typename Graph::Action act(Agent agent, EpisodeKey key, Seq step,
                           const typename Graph::Observation& observation,
                           [[maybe_unused]] Program& program) {
  if constexpr (Graph::kHasPolicy) {
    if (agent == Agent::policy) return policy_action<Graph>(observation, program);
  }
  if (agent == Agent::random) return Graph::random(key, step);
  return Graph::zero();
}

/// False if the other program of a split graph is gone. A program that is not split is linked.
template <class Program>
bool is_linked(const Program& program) {
  if constexpr (requires { program.link().ok(); }) {
    return program.link().ok();
  } else {
    return true;
  }
}

/// A program that requests messages before it needs them waits for those in flight.
template <class Program>
void drain(Program& program) {
  if constexpr (requires { program.drain(); }) program.drain();
}

/// The action applied in the last step: another program's decision, once it has arrived.
template <class Program, class Action>
void find_applied([[maybe_unused]] const Program& program, [[maybe_unused]] Action& action) {
  if constexpr (requires { program.applied(); }) action = program.applied();
}

/// The action applied instead of the agent's. In a split graph, the program that has the
/// agent has the guard.
template <class Program, class Action>
Action guarded(Program& program, const Action& wanted, std::uint64_t late_in_a_row) {
  if constexpr (requires { program.guard; }) {
    return program.guard.check(wanted, late_in_a_row);
  } else {
    return static_cast<void>(late_in_a_row), wanted;
  }
}

/// A step with an action that the guard has seen, or that is repeated from a log.
template <class Program, class Action>
auto apply(Program& program, Action& action) {
  if constexpr (requires { program.step_checked(action); }) {
    return program.step_checked(action);
  } else if constexpr (requires { program.guard; }) {
    return program.step_unguarded(action);
  } else {
    return program.step(action);
  }
}

/// The end of a run before its time: the safe action, in the program that has the agent.
template <class Graph, class Program>
typename Graph::Observation step_safely(Program& program) {
  if constexpr (requires { program.guard; }) {
    return program.step_safely();
  } else {
    typename Graph::Action action{};
    return program.step(action);
  }
}

/// Before the first reset: a graph of nodes alone has nothing to start.
template <class Program>
void warm_up(Program& program) {
  if constexpr (requires { program.warm_up(); }) program.warm_up();
}
template <class Program>
void stop(Program& program) {
  if constexpr (requires { program.stop(); }) program.stop();
}
/// Whether the program acts on the world itself.
template <class Program>
bool is_real(const Program& program) {
  if constexpr (requires { program.is_real(); }) {
    return program.is_real();
  } else {
    return false;
  }
}

/// Whether a graph's state `i` can be set while an episode runs.
template <class Graph>
constexpr bool is_tunable([[maybe_unused]] std::size_t i) {
  if constexpr (requires { Graph::kTunable; }) {
    return Graph::kTunable[i];
  } else {
    return false;
  }
}
/// Sets parameters from `states` between two steps; empty ones keep their values.
template <class Program, class States>
void tune([[maybe_unused]] Program& program, [[maybe_unused]] const States& states) {
  if constexpr (requires { program.tune(states); }) program.tune(states);
}

/// Whether a step was the last of its episode, as the graph's task says.
template <class Outcome>
bool has_ended(const Outcome& outcome) {
  if constexpr (requires { outcome.terminated; }) {
    return outcome.terminated || outcome.truncated;
  } else {
    return static_cast<void>(outcome), false;
  }
}

/// The reward of the last step; none without a task.
template <class Graph, class Program>
typename OutcomeOf<Graph>::Type outcome_of(const Program& program) {
  if constexpr (requires { program.outcome(); }) {
    return program.outcome();
  } else {
    return static_cast<void>(program), NoOutcome{};
  }
}

/// The observer of the steps of run_episodes(), which may change them: a class derived from this
/// one hides the functions that it has use for. None is virtual, for boards.
template <class Graph>
struct Watch {
  using Action = typename Graph::Action;
  using Observation = typename Graph::Observation;
  using Outcome = typename OutcomeOf<Graph>::Type;
  using States = typename Graph::States;

  /// Before an episode and before a step. False ends the run.
  bool go_on() { return true; }
  /// Between two episodes, when the other program of a split graph is gone: whether it is back.
  bool link_again() { return false; }
  /// The key of an episode that is planned with another one.
  EpisodeKey key(EpisodeKey planned) { return planned; }
  /// An episode begins, before its reset.
  void begin(EpisodeKey /*key*/) {}
  /// The initial state.
  States states(EpisodeKey key) { return Graph::sample(key); }
  void reset(std::uint32_t /*episode*/, const Observation& /*observation*/) {}
  /// Whether an episode ends before its last step.
  bool is_over() { return false; }
  /// How many steps up to now were too late.
  std::uint64_t late_in_a_row() { return 0; }
  /// `step` counts from 1; `action`: the applied one.
  void step(std::uint32_t /*episode*/, Seq /*step*/, const Action& /*action*/,
            const Observation& /*observation*/, const Outcome& /*outcome*/) {}
  /// Whether messages of a step are used before the next one. If not, the program does not wait for
  /// a part's messages and decisions.
  bool looks() { return true; }
};

/// Runs `plan`; an episode has fewer steps if the graph's task ends it. `agent(key, step,
/// observation)` returns an action, and the program's guard decides what is applied. If a link to
/// another program is lost, the episode ends, and `watch` does not see that step. The run ends,
/// too, unless `watch` reconnects the other program.
template <class Graph, class Program, class AgentFunction, class WatchOfRun>
void run_episodes(const RunPlan& plan, Program& program, AgentFunction&& agent, WatchOfRun& watch) {
  for (std::uint32_t episode = 0; episode < plan.episodes; ++episode) {
    drain(program);
    if (!(is_linked(program) || watch.link_again()) || !watch.go_on()) return;
    const EpisodeKey key = watch.key({plan.seed, plan.environment, episode});
    watch.begin(key);
    program.hooks.on_episode(episode);
    typename Graph::Observation observation = program.reset(watch.states(key));
    if (watch.looks()) drain(program);
    if (!is_linked(program)) continue;
    watch.reset(episode, observation);
    for (std::uint64_t step = 0; step < plan.steps; ++step) {
      if (!watch.go_on()) return;
      if (watch.is_over()) break;
      const typename Graph::Action wanted = agent(key, step, observation);
      typename Graph::Action action = guarded(program, wanted, watch.late_in_a_row());
      observation = apply(program, action);
      if (watch.looks()) drain(program);
      if (!is_linked(program)) break;
      find_applied(program, action);
      const auto outcome = outcome_of<Graph>(program);
      watch.step(episode, step + 1, action, observation, outcome);
      if (has_ended(outcome)) break;
    }
  }
}

/// Calls f(name, count) for each counter of a program. Counts have 32 or 64 bits.
template <class Program, class F>
void for_each_fault(const Program& program, F&& f) {
  if constexpr (requires { program.steps_before_reset(); })
    f("safe: steps before the first reset", program.steps_before_reset());
  if constexpr (requires { program.reset_timeouts(); })
    f("reset timeouts", program.reset_timeouts());
  if constexpr (requires { program.memory_faults(); }) f("memory faults", program.memory_faults());
  if constexpr (requires { program.refused_delays(); })
    f("refused delays", program.refused_delays());
  if constexpr (requires { program.for_each_count(f); }) program.for_each_count(f);
  if constexpr (requires { program.guard; }) program.guard.for_each_count(f);
}

}  // namespace eagerx::target

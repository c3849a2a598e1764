// A batch's operations on SIMD groups, compiled once for each instruction set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/hooks.hpp>
#include <eagerx/random.hpp>

namespace eagerx::environments {

/// Rows of a whole SIMD group, from its first environment on; null where they are not wanted.
struct SimdRows {
  float* observation = nullptr;
  std::size_t observed = 0;             // numbers of a row
  const std::size_t* places = nullptr;  // in it, of the numbers in the graph's order
  float* reward = nullptr;
  float* terms = nullptr;
  std::uint8_t* success = nullptr;
  std::uint8_t* terminated = nullptr;
  std::uint8_t* truncated = nullptr;
  std::uint32_t* steps = nullptr;  // of the episodes; never null
  std::uint32_t most_steps = 0;    // after this number a lane is notable

  /// Whether they tell which episodes the task ends: no columns do then.
  bool have_ends() const { return terminated != nullptr && truncated != nullptr; }
};

/// Rows of actions of a whole SIMD group.
struct ActionRows {
  const float* first = nullptr;
  std::size_t acted = 0;                // numbers of a row
  const std::size_t* places = nullptr;  // in it, of the first number of each action of the graph
};

/// The functions of SIMD groups for one instruction set. Only plain numbers and objects of the
/// program for one environment pass through them, so that the rest of the library does not use
/// vectors. All are null without lanes.
template <class Graph>
struct SimdKernel {
  using Program = typename Graph::template Program<NoHooks>;
  using Action = typename Graph::Action;
  using States = typename Graph::States;

  const char* isa = "";  // as EAGERX_SIMD names it
  std::uint32_t lanes = 0;
  std::size_t bytes = 0, alignment = 0;  // of a SIMD group
  std::size_t action_bytes = 0;          // of the actions of a SIMD group, aligned as it
  std::size_t columns = 0;               // that step() writes, [columns][lanes]
  std::uint32_t most_steps = 0;          // of an episode; what a lane counts with has an end
  bool answers = false;                  // whether guards look at observations
  std::size_t reported = 0;  // observations of which columns say whether they are finite
  std::uint32_t phases = 1;  // of a SIMD group: steps after which every rate is due again
  /// The inputs of the agent's policy, in this order: observations by their places in the graph.
  /// Null if there is no policy, or one that remembers.
  const std::size_t* observations = nullptr;
  std::size_t inputs = 0;  // of the policy: the numbers of these

  /// No environment is in any lane.
  void (*make)(void* group) = nullptr;
  /// Whether `one` may be loaded next to the lanes that hold environments: it is in their phase.
  bool (*fits_next_to)(const void* group, const Program& one) = nullptr;
  /// A SIMD group without environments goes to the phase of `one`.
  void (*go_to)(void* group, const Program& one) = nullptr;
  void (*load)(void* group, std::uint32_t lane, const Program& one) = nullptr;
  void (*store)(const void* group, std::uint32_t lane, Program& one) = nullptr;
  /// Like store(), reset() of `one` and load(), but only for the data that the reset needs. Null if
  /// these may depend on more: reset nodes, several phases.
  typename Graph::Observation (*restart)(void* group, std::uint32_t lane, Program& one,
                                         const States& states) = nullptr;
  /// As the graph's sample() for each of `count` keys, at most `most_samples`.
  void (*sample)(const EpisodeKey* keys, std::size_t count, States* states) = nullptr;
  std::uint32_t most_samples = 0;
  /// Fills `actions` of a SIMD group. Returns the lanes, a bit each, whose action must still pass
  /// through the guard: pass the result to put(). Null if all must.
  std::uint64_t (*take)(const ActionRows& rows, void* actions) = nullptr;
  void (*put)(void* actions, std::uint32_t lane, const Action& action) = nullptr;
  /// `actions` have gone through the guards. Columns: observations in the graph's order, unless
  /// their rows are wanted and no guard looks at them, then those of SimdColumns, unless rows have
  /// the ends. `rows`: null, or also written. The lanes, a bit each, whose episode the task
  /// ends, whose reward is not a number or which have made the most steps.
  std::uint64_t (*step)(void* group, const void* actions, float* columns,
                        const SimdRows* rows) = nullptr;
  /// The actions [lanes] of the agent's policy. `columns`: its inputs [inputs][lanes].
  void (*act)(const float* columns, Action* actions) = nullptr;
};

/// Columns after the observations: booleans are 0 or 1.
enum SimdColumns : std::size_t {
  kFinite,  // whether the observation is
  kReward,
  kTerminated,
  kTruncated,
  kSuccess,
  kTerms  // and the weighted terms of the reward; then what the critic of a training sees; then
          // whether each observation is finite
};

/// The results of a step of a SIMD group for one environment.
struct SimdColumn {
  const float* first = nullptr;
  std::size_t lanes = 0;     // from one number to the next
  std::size_t observed = 0;  // numbers of an observation

  float number(std::size_t i) const { return first[i * lanes]; }
  float end(std::size_t column) const { return number(observed + column); }
};

}  // namespace eagerx::environments

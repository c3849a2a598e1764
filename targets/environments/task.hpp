// The task of a graph, if it has one: reward and end of an episode.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <iterator>
#include <targets/environments/simd_kernel.hpp>

namespace eagerx::environments {

template <class Graph>
constexpr bool says_task() {
  if constexpr (requires { Graph::kHasTask; }) {
    return Graph::kHasTask;
  } else {
    return false;
  }
}
/// Whether there is a `task:` in the graph. Without one the reward is 0 and nothing but the batch
/// ends an episode.
template <class Graph>
inline constexpr bool has_task = says_task<Graph>();

template <class Graph>
constexpr std::size_t count_terms() {
  if constexpr (has_task<Graph>) {
    return std::size(Graph::kTermNames);
  } else {
    return 0;
  }
}
/// Terms of the reward.
template <class Graph>
inline constexpr std::size_t terms_of = count_terms<Graph>();

template <class Graph>
constexpr std::size_t count_seen() {
  if constexpr (requires { Graph::Outcome::kSeen; }) {
    return Graph::Outcome::kSeen;
  } else {
    return 0;
  }
}
/// Numbers of the messages that the critic of a training sees.
template <class Graph>
inline constexpr std::size_t seen_of = count_seen<Graph>();
/// The column of a SIMD group, after the observations, for whether the first result is finite.
template <class Graph>
inline constexpr std::size_t reported_at = kTerms + terms_of<Graph> + seen_of<Graph>;

/// How a step ended.
struct EpisodeEnds {
  bool terminated = false;
  bool truncated = false;
  bool is_finite = true;  // the reward
};

/// Writes reward, success and terms of the program's last step as environment `k`.
template <class Graph, class Program>
EpisodeEnds write_outcome([[maybe_unused]] const Program& program, std::uint32_t k,
                          const eagerx_rows& rows) {
  if constexpr (has_task<Graph>) {
    const auto& outcome = program.outcome();
    if (rows.reward != nullptr) rows.reward[k] = static_cast<float>(outcome.reward);
    if (rows.success != nullptr) rows.success[k] = outcome.success ? 1 : 0;
    if (rows.terms != nullptr) {
      for (std::size_t i = 0; i < terms_of<Graph>; ++i)
        rows.terms[k * terms_of<Graph> + i] = static_cast<float>(element(outcome.terms, i));
    }
    return {outcome.terminated, outcome.truncated, eagerx::isfinite(outcome.reward)};
  } else {
    if (rows.reward != nullptr) rows.reward[k] = 0.0F;
    if (rows.success != nullptr) rows.success[k] = 0;
    return {};
  }
}

template <class Graph>
EpisodeEnds ends_of(const SimdColumn& column) {
  if constexpr (has_task<Graph>) {
    return {column.end(kTerminated) != 0.0F, column.end(kTruncated) != 0.0F,
            eagerx::isfinite(column.end(kReward))};
  } else {
    return {};
  }
}

/// ends_of(), where the rows of environment `k` have been written.
template <class Graph>
EpisodeEnds ends_in_rows(const SimdColumn& column, std::uint32_t k, const eagerx_rows& rows) {
  if constexpr (has_task<Graph>) {
    return {rows.terminated[k] != 0, rows.truncated[k] != 0, eagerx::isfinite(column.end(kReward))};
  } else {
    return {};
  }
}

/// write_outcome() of a step in a SIMD group.
template <class Graph>
void write_outcome(const SimdColumn& column, std::uint32_t k, const eagerx_rows& rows) {
  if (rows.reward != nullptr) rows.reward[k] = has_task<Graph> ? column.end(kReward) : 0.0F;
  const auto is_true = [&](SimdColumns end) { return has_task<Graph> && column.end(end) != 0.0F; };
  if (rows.success != nullptr) rows.success[k] = is_true(kSuccess) ? 1 : 0;
  if (rows.terms != nullptr) {
    for (std::size_t i = 0; i < terms_of<Graph>; ++i)
      rows.terms[k * terms_of<Graph> + i] = column.end(kTerms + i);
  }
}

/// Reward and terms of a step in a SIMD group, of a graph with a task.
template <class Graph>
typename Graph::Outcome outcome_of(const SimdColumn& column) {
  typename Graph::Outcome outcome{};
  outcome.reward = column.end(kReward);
  for (std::size_t i = 0; i < terms_of<Graph>; ++i) outcome.terms[i] = column.end(kTerms + i);
  return outcome;
}

/// The same where there was no step.
template <class Graph>
void write_no_outcome(std::uint32_t k, const eagerx_rows& rows) {
  if (rows.reward != nullptr) rows.reward[k] = 0.0F;
  if (rows.success != nullptr) rows.success[k] = 0;
  if (rows.terms != nullptr) {
    for (std::size_t i = 0; i < terms_of<Graph>; ++i) rows.terms[k * terms_of<Graph> + i] = 0.0F;
  }
  if (rows.terminated != nullptr) rows.terminated[k] = 0;
  if (rows.truncated != nullptr) rows.truncated[k] = 0;
}

}  // namespace eagerx::environments

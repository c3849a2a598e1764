// Begins episodes in a batch: their initial states, and the program or lane that steps them.
#pragma once

#include <cstdint>
#include <eagerx/random.hpp>
#include <targets/environments/base/state_rows.hpp>
#include <targets/environments/beginning.hpp>
#include <targets/environments/episode.hpp>
#include <targets/environments/held.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/simd_kernel.hpp>
#include <targets/environments/stages.hpp>

namespace eagerx::environments {

/// Each call passes the environments of the batch.
template <class Graph>
class Resets {
 public:
  using States = typename Graph::States;

  SetRows set_states{Layout<Graph>::get().states};
  Staging<Graph> staging;

  Resets(const SimdKernel<Graph>& kernel, std::uint32_t environments)
      : staging(environments), sampler_(kernel) {}

  /// Environment `k` begins an episode before the end of the step: now, if enough are waiting to
  /// sample together.
  void begin_later(Held<Graph>& held, std::uint32_t k, Step& step) {
    step.environments[step.waiting++] = k;
    if (step.waiting == sampler_.most()) begin_all(held, step);
  }
  void begin_all(Held<Graph>& held, Step& step) {
    if (step.waiting != 0) begin_waiting(held, step);
  }

  /// That the current episode of environment `k` begins with.
  States states_of(std::uint32_t k, EpisodeKey key) const {
    States states = Graph::sample(key);
    put_own(k, key, states);
    return states;
  }

 private:
  [[gnu::noinline]] void begin_waiting(Held<Graph>& held, Step& step) {
    EpisodeKey keys[Step::kMost];
    States states[Step::kMost];
    for (std::uint32_t i = 0; i < step.waiting; ++i)
      keys[i] = held.episodes[step.environments[i]].key();
    sampler_.sample(keys, step.waiting, states);
    for (std::uint32_t i = 0; i < step.waiting; ++i)
      begin(held, step.environments[i], states[i], step.rows.observation);
    step.waiting = 0;
  }

  /// `states`: as the graph samples them.
  void begin(Held<Graph>& held, std::uint32_t k, States& states, float* observations) {
    Episode& episode = held.episodes[k];
    set_states.begin(k);
    staging.begin(k);
    put_own(k, episode.key(), states);
    const bool continues = episode.vectorized && held.simd.restarts() && !held.traces.contains(k);
    if (!continues) held.take_out(k);
    const auto observation = continues ? held.simd.restart(k, held.programs[k], states)
                                       : held.reset_program(k, episode.key(), states);
    held.with(k, [&](const auto& program) { held.critic.begin(k, program, states); });
    if (observations != nullptr)
      layout_.write(observation, observations + k * layout_.observations.numbers());
    held.steps[k] = 0;
    episode.begun = true;
    episode.ended = false;
    if (held.simd.lanes() != 0 && !episode.traced && !continues) held.put_in(k);
  }

  /// The states that the stage samples differently from the graph, and those that were set.
  void put_own(std::uint32_t k, EpisodeKey key, States& states) const {
    staging.sample(k, key, states);
    if (const float* const row = set_states.row(k)) layout_.read(row, states);
  }

  const Layout<Graph>& layout_ = Layout<Graph>::get();
  Sampler<Graph> sampler_;
};

}  // namespace eagerx::environments

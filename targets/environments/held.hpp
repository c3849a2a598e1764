// The environments of a batch: the episode of each, and the program or lane that runs it.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <cstdint>
#include <eagerx/random.hpp>
#include <map>
#include <memory>
#include <string>
#include <targets/common/run.hpp>
#include <targets/environments/base/problem.hpp>
#include <targets/environments/critic.hpp>
#include <targets/environments/episode.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/pictures.hpp>
#include <targets/environments/simd_memory.hpp>
#include <targets/environments/traced.hpp>
#include <utility>

namespace eagerx::environments {

/// A vectorized environment runs in its lane, a traced one in the program of its trace, and any
/// other in its own program.
template <class Graph>
struct Held {
  using Program = typename Graph::template Program<NoHooks>;

  std::uint32_t size;
  std::unique_ptr<Episode[]> episodes;     // [size]
  std::unique_ptr<std::uint32_t[]> steps;  // [size], of the episodes
  DrawnPrograms<Graph> drawn;
  std::unique_ptr<Program[]> programs;  // [size], or one if `drawn` has them
  SimdMemory<Graph> simd;
  CriticRows<Graph> critic;
  std::map<std::uint32_t, Traces<Graph>> traces;

  Held(const eagerx_options& options, const SimdKernel<Graph>& kernel)
      : size(options.environments),
        episodes(std::make_unique<Episode[]>(size)),
        steps(std::make_unique<std::uint32_t[]>(size)),
        drawn(options.pictures != 0 ? size : 0),
        programs(std::make_unique<Program[]>(plain_programs())),
        simd(drawn.any() ? SimdKernel<Graph>{} : kernel, size),
        critic(size) {
    for (std::uint32_t k = 0; k < size; ++k) {
      episodes[k].seed = options.seed;
      episodes[k].number = options.numbers != nullptr ? options.numbers[k] : k;
    }
  }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  ~Held() = default;

  /// At the end of a run. Not done by a destructor: where the batch was refused, nothing has begun.
  void stop() {
    for (std::uint32_t k = 0; k < size; ++k)
      untraced(k, [](auto& program) { target::stop(program); });
    for (auto& [k, kept] : traces) {
      if (kept.now) target::stop(kept.now->program);
    }
  }

  /// f(program) of environment `k`, which is not vectorized.
  template <class F>
  decltype(auto) with(std::uint32_t k, F&& f) {
    return episodes[k].traced ? f(traces.find(k)->second.now->program)
                              : untraced(k, std::forward<F>(f));
  }
  template <class F>
  decltype(auto) untraced(std::uint32_t k, F&& f) const {
    if constexpr (has_render<Graph>) {
      if (drawn.any()) return f(drawn[k]);
    }
    return f(programs[k]);
  }

  void put_in(std::uint32_t k) {
    simd.load(k, programs[k]);
    episodes[k].vectorized = true;
  }
  /// Back into its own program.
  void take_out(std::uint32_t k) {
    if (!episodes[k].vectorized) return;
    simd.store(k, programs[k]);
    simd.leave(k);
    episodes[k].vectorized = false;
  }

  /// Starts an episode in the program of `k`, or in that of its trace.
  typename Graph::Observation reset_program(std::uint32_t k, EpisodeKey key,
                                            const typename Graph::States& states) {
    if (const auto found = traces.find(k); found != traces.end()) {
      if (Traced<Graph>* const traced = found->second.take()) {
        episodes[k].traced = true;
        return traced->reset(key, states);
      }
    }
    return untraced(k, [&](auto& program) {
      if constexpr (requires { program.hooks.forget(); }) program.hooks.forget();
      return program.reset(states);
    });
  }

  /// Parameters of `k`'s episode, from a row of states that was checked.
  void tune(std::uint32_t k, const float* row) {
    typename Graph::States set{};
    Layout<Graph>::get().read(row, set);
    const bool was_vectorized = episodes[k].vectorized;
    take_out(k);
    if (episodes[k].traced) {
      traces.find(k)->second.now->tune(steps[k], set);
    } else {
      untraced(k, [&](auto& program) { target::tune(program, set); });
    }
    if (was_vectorized) put_in(k);
  }

  /// Null: ends the file. Empty: only the hash. If the file cannot be written, the old trace stays.
  void trace(std::uint32_t k, const char* path) {
    Traces<Graph>& kept = traces[k];
    if (path == nullptr) {
      kept.end();
      return;
    }
    if constexpr (requires(const Program& program) { program.reset_timeouts(); }) {
      if (episodes[k].begun)
        refuse("a trace of a graph with reset nodes begins before the first reset");
    }
    kept.begin(path, drawn.any());
  }
  /// 0 without a trace.
  std::uint64_t hash(std::uint32_t k) const {
    const auto found = traces.find(k);
    return found != traces.end() && found->second.now ? found->second.now->program.hooks.hash() : 0;
  }
  /// Behind each step.
  void hand_on_traces() {
    for (auto& [k, kept] : traces) {
      if (kept.now) kept.now->hand_on();
    }
  }

  /// Calls add(name, count) for each count of guards and nodes of each environment.
  template <class F>
  void for_each_fault(F&& add) const {
    for (std::uint32_t k = 0; k < size; ++k) {
      if (episodes[k].vectorized) simd.store(k, programs[k]);
      untraced(k, [&](auto& program) { target::for_each_fault(program, add); });
    }
    for (const auto& [k, kept] : traces) {
      if (kept.now) target::for_each_fault(kept.now->program, add);
    }
  }

 private:
  /// Where environments draw, only the one that tells what the graph has.
  std::uint32_t plain_programs() const { return drawn.any() ? 1 : size; }
};

}  // namespace eagerx::environments

// Many environments of one graph: their episodes, on all cores. Environment k has the same bits
// alone, in a SIMD group, in any batch and on any number of threads.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <runtime/host/base/thread_pool.hpp>
#include <string>
#include <string_view>
#include <targets/common/run.hpp>
#include <targets/environments/agent.hpp>
#include <targets/environments/base/description.hpp>
#include <targets/environments/base/problem.hpp>
#include <targets/environments/base/workload.hpp>
#include <targets/environments/beginning.hpp>
#include <targets/environments/held.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/not_finite.hpp>
#include <targets/environments/pictures.hpp>
#include <targets/environments/resets.hpp>
#include <targets/environments/task.hpp>
#include <utility>

namespace eagerx::environments {

/// Throws Problem for errors of the caller, and std::bad_alloc and std::system_error in its
/// constructor. After that it allocates only for states that are set, traces and counts.
template <class Graph>
class Batch {
 public:
  using Program = typename Graph::template Program<NoHooks>;

  /// `options` are in range; `kernel` has lanes where environments can run vectorized.
  Batch(const eagerx_options& options, const SimdKernel<Graph>& kernel)
      : longest_(options.longest),
        autoreset_(options.autoreset),
        held_(options, kernel),
        resets_(kernel, held_.size),
        agents_(kernel),
        pool_(std::min(options.threads != 0 ? options.threads : host::usable_cores(), blocks())) {
    held_.simd.make_room(pool_.size());
    agents_.make_room(pool_.size());
    if (target::is_real(held_.programs[0])) {
      refuse("engine `" + std::string(Graph::kEngine) +
             "` drives real hardware, of which there is one: generate the library with `--engine` "
             "and an engine that simulates");
    }
    // By all members: a library may need memory for each thread, too.
    pool_.run(pool_.size(), [&](unsigned i) {
      for (std::uint32_t k = i; k < size(); k += pool_.size())
        held_.with(k, [](auto& program) { target::warm_up(program); });
    });
  }
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;
  ~Batch() { held_.stop(); }

  std::uint32_t size() const { return held_.size; }
  bool draws() const { return held_.drawn.any(); }

  void reset(const std::uint8_t* mask, const std::uint64_t* seeds, float* observation) {
    eagerx_rows rows{};
    rows.observation = observation;
    runs_single_ = false;
    each_block(resetting_, [&](std::uint32_t first, std::uint32_t end, unsigned /*member*/) {
      Step step(rows);
      for (std::uint32_t k = first; k < end; ++k) {
        if (mask != nullptr && mask[k] == 0) continue;
        Episode& episode = held_.episodes[k];
        if (seeds != nullptr) {
          episode.seed = seeds[k];
          episode.index = 0;
        } else if (episode.begun) {
          ++episode.index;
        }
        resets_.begin_later(held_, k, step);
      }
      resets_.begin_all(held_, step);
    });
    if (!all_begun_) {
      all_begun_ = std::all_of(held_.episodes.get(), held_.episodes.get() + held_.size,
                               [](const Episode& episode) { return episode.begun; });
    }
    find_single();
  }

  /// False if a reward is not finite: problem() says which.
  [[gnu::always_inline]] inline bool step(const float* actions, const eagerx_rows& rows) {
    if (!runs_single_) return step_all(actions, rows);
    Step step(rows);
    step_single(actions, step);
    return runs_single_ || finish(step);
  }
  std::string problem() const { return not_finite_.text(); }

  /// The next action of the graph's agent, for environments whose episode has not ended.
  void act(const float* observations, float* actions) {
    require_begun();
    const target::Agent agent = agent_of_graph<Graph>();
    const auto is_running = [&](std::uint32_t k) { return !held_.episodes[k].ended; };
    const auto act_alone = [&](std::uint32_t k, const auto& observation) {
      return held_.with(k, [&](auto& program) {
        return target::act<Graph>(agent, held_.episodes[k].key(), held_.steps[k], observation,
                                  program);
      });
    };
    std::atomic<const char*> refused = nullptr;
    each_block(acting_, [&](std::uint32_t first, std::uint32_t end, unsigned member) {
      const Rows rows{first, end, observations, actions};
      if (const char* name = agents_.act(member, rows, is_running, act_alone)) refused = name;
    });
    if (refused != nullptr) {
      refuse("float32 has no such action `" + std::string(refused) +
             "` as the agent wants: generate the library for a graph of floats");
    }
  }

  void set_states(const std::uint8_t* mask, const float* states) {
    resets_.set_states.set(held_.size, mask, states);
  }

  /// Sets the stage of the next episodes; empty: the graph as written. Throws Problem, and then
  /// changes nothing.
  void set_stage(const std::uint8_t* mask, std::string_view stage) {
    resets_.staging.set(mask, stage);
  }

  /// Parameters of running episodes; NaN: unchanged. Throws Problem, with nothing changed.
  void tune(const std::uint8_t* mask, const float* states) {
    require_begun();
    layout_.states.check_tuning(held_.size, mask, states);
    for (std::uint32_t k = 0; k < held_.size; ++k) {
      if (mask == nullptr || mask[k] != 0)
        held_.tune(k, states + k * layout_.states.columns.numbers());
    }
  }

  template <class Number>
  void get_states(Number* states) const {
    require_begun();
    for (std::uint32_t k = 0; k < held_.size; ++k)
      layout_.write(resets_.states_of(k, held_.episodes[k].key()),
                    states + k * layout_.states.columns.numbers());
  }

  /// The critic's observation in a training; null is not written.
  void critic(float* rows, float* final_rows) const {
    require_begun();
    held_.critic.read(rows, final_rows);
  }

  /// Null: ends the file. Empty: only the hash. If the file cannot be written, the old trace stays.
  void trace(std::uint32_t k, const char* path) {
    runs_single_ = false;
    held_.trace(k, path);
  }
  std::uint64_t hash(std::uint32_t k) const { return held_.hash(k); }

  /// Sums of nonzero counts over all environments.
  Counts counts() const {
    Counts sums;
    const auto add = [&](const char* name, std::uint64_t count) { sums.add(name, count); };
    held_.for_each_fault(add);
    not_finite_.for_each_count(add);
    return sums;
  }

  /// `pixels` [height][width][3]: the last picture of the environment; white before the first one.
  void picture(std::uint32_t k, const picture::Image& pixels) {
    if (!held_.drawn.any())
      refuse("these environments draw nothing: set `pictures` of eagerx_options to 1");
    held_.with(k, [&](auto& program) {
      if constexpr (requires { program.hooks.paint(held_.drawn.painter(), pixels); })
        program.hooks.paint(held_.drawn.painter(), pixels);
    });
  }

  bool has_threads() const { return pool_.is_complete(); }

 private:
  std::uint32_t block() const { return block_of(held_.size, held_.simd.lanes()); }
  unsigned blocks() const { return (held_.size + block() - 1) / block(); }

  /// f(first, end, thread of the pool) for all environments, by as many threads as the work is
  /// worth.
  template <class F>
  void each_block(Workload& workload, F&& f) {
    if (pool_.size() == 1) return f(0U, held_.size, 0U);
    workload.run(pool_, held_.size, block(), BlockWork(f));
  }

  [[gnu::noinline]] bool step_all(const float* actions, const eagerx_rows& rows) {
    require_begun();
    not_finite_.begin_step();
    each_block(stepping_, [&](std::uint32_t first, std::uint32_t end, unsigned member) {
      Step step(rows);
      step_block(first, end, member, actions, step);
      resets_.begin_all(held_, step);
    });
    held_.hand_on_traces();
    find_single();
    return !not_finite_.is_any();
  }

  /// Where the step of the single environment was more than a step.
  [[gnu::noinline]] bool finish(Step& step) {
    resets_.begin_all(held_, step);
    find_single();
    return !not_finite_.is_any();
  }
  void find_single() {
    runs_single_ = held_.size == 1 && held_.simd.lanes() == 0 && !held_.drawn.any() &&
                   held_.traces.empty() && held_.episodes[0].begun && !held_.episodes[0].ended &&
                   !not_finite_.is_any();
  }
  void step_block(std::uint32_t first, std::uint32_t end, unsigned member, const float* actions,
                  Step& step) {
    const std::uint32_t lanes = held_.simd.lanes();
    if (lanes == 0) {
      for (std::uint32_t k = first; k < end; ++k) step_alone(k, actions, step);
    } else {
      for (; first < end; first += lanes)
        step_group(first, std::min(end, first + lanes), member, actions, step);
    }
  }

  void step_group(std::uint32_t first, std::uint32_t end, unsigned member, const float* actions,
                  Step& step) {
    const std::uint64_t all = ~std::uint64_t{0} >> (64 - (end - first));
    const std::uint64_t vectorized = held_.simd.vectorized(first);
    if (vectorized != 0) take_actions(first, end, member, actions);
    const std::uint64_t alone = all & ~vectorized;  // a bit for each lane
    // The row of an ended episode stays unchanged if no episode begins there.
    if (vectorized != 0 && held_.simd.writes_rows(end - first) &&
        (alone == 0 || autoreset_ != EAGERX_DISABLED)) {
      step_whole_group(first, alone, member, actions, step);
      return;
    }
    if (vectorized != 0) held_.simd.step(member, first, nullptr);
    for (std::uint32_t k = first; k < end; ++k) {
      if (!held_.episodes[k].vectorized) {
        step_alone(k, actions, step);
        continue;
      }
      const SimdColumn column = held_.simd.column(member, k, k - first);
      held_.simd.show_guard(column, held_.programs[k]);
      write_outcome<Graph>(column, k, step.rows);
      weigh(k, column, step.rows);
      held_.critic.step(k, column);
      end_group_step(k, column, ends_of<Graph>(column), step,
                     [&](float* row) { held_.simd.write(column, layout_, row); });
    }
  }

  /// The actions after the guards.
  void take_actions(std::uint32_t first, std::uint32_t end, unsigned member, const float* actions) {
    std::uint64_t guarded =
        held_.simd.take(member, first, end - first, actions) & held_.simd.vectorized(first);
    for (; guarded != 0; guarded &= guarded - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(guarded));
      const std::uint32_t k = first + lane;
      const float* const row = actions + k * layout_.actions.numbers();
      held_.simd.put(member, lane, applied_action(held_.programs[k], layout_.action(row)));
    }
  }

  /// The rows of all lanes at once; then the lanes that differ.
  void step_whole_group(std::uint32_t first, std::uint64_t alone, unsigned member,
                        const float* actions, Step& step) {
    const SimdRows simd_rows = held_.simd.rows_from(first, step.rows, held_.steps.get(), longest_);
    std::uint64_t notable = held_.simd.step(member, first, &simd_rows) | alone;
    if constexpr (SimdMemory<Graph>::shows_guard()) {
      for (std::uint32_t lane = 0; lane < held_.simd.lanes(); ++lane) {
        if ((alone >> lane & 1U) == 0)
          held_.simd.show_guard(held_.simd.column(member, first, lane),
                                held_.programs[first + lane]);
      }
    }
    constexpr bool kLooks = seen_of<Graph> + Staging<Graph>::kStages > 0;
    for (std::uint32_t lane = 0; kLooks && lane < held_.simd.lanes(); ++lane) {
      if ((alone >> lane & 1U) != 0) continue;
      const SimdColumn column = held_.simd.column(member, first, lane);
      held_.critic.step(first + lane, column);
      weigh(first + lane, column, step.rows);
    }
    for (; notable != 0; notable &= notable - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(notable));
      const std::uint32_t k = first + lane;
      --held_.steps[k];
      if ((alone >> lane & 1U) != 0) {
        step_alone(k, actions, step);
      } else {
        const SimdColumn column = held_.simd.column(member, first, lane);
        const EpisodeEnds ends = simd_rows.have_ends() ? ends_in_rows<Graph>(column, k, step.rows)
                                                       : ends_of<Graph>(column);
        end_group_step(k, column, ends, step, [&](float* row) {
          if (step.rows.observation == nullptr) return held_.simd.write(column, layout_, row);
          const std::size_t observed = layout_.observations.numbers();
          const float* const written = step.rows.observation + k * observed;
          if (row != written) std::copy_n(written, observed, row);
        });
      }
    }
  }

  /// write(row) writes the observation of the step.
  template <class Write>
  void end_group_step(std::uint32_t k, const SimdColumn& column, EpisodeEnds ends, Step& step,
                      Write&& write) {
    if constexpr (has_task<Graph>) {
      if (!ends.is_finite) [[unlikely]]
        not_finite_.note(held_.episodes[k].place(k, held_.steps[k]), outcome_of<Graph>(column));
    }
    end_step(k, ends, step, std::forward<Write>(write));
    if (held_.steps[k] >= held_.simd.most_steps()) held_.take_out(k);
  }

  void weigh(std::uint32_t k, const SimdColumn& column, const eagerx_rows& rows) const {
    resets_.staging.weigh(k, rows, [&](std::size_t i) { return column.end(kTerms + i); });
  }

  void step_alone(std::uint32_t k, const float* actions, Step& step) {
    if (held_.episodes[k].ended) {
      stay_or_begin(k, step);
    } else {
      held_.with(k, [&](auto& program) { step_one(k, program, actions, step); });
    }
  }

  template <class AnyProgram>
  void step_one(std::uint32_t k, AnyProgram& program, const float* actions, Step& step) {
    const std::size_t acted = layout_.actions.numbers();
    const auto observation = program.step(layout_.action(actions + k * acted));
    end_step(k, write_step(k, program, step), step,
             [&](float* row) { layout_.write(observation, row); });
  }

  /// step_one() of the only environment, within its caller: no place in a row is calculated.
  [[gnu::always_inline]] inline void step_single(const float* actions, Step& step) {
    Program& program = held_.programs[0];
    const auto observation = program.step(layout_.action(actions));
    const auto write = [&](float* row) { layout_.write(observation, row); };
    if (!write_ends(0, write_step(0, program, step), step.rows)) [[unlikely]] {
      runs_single_ = false;
      end_episode(0, step, write);
    } else if (step.rows.observation != nullptr) {
      write(step.rows.observation);
    }
  }

  /// The results of a step, except the observation.
  template <class AnyProgram>
  [[gnu::always_inline]] inline EpisodeEnds write_step(std::uint32_t k, AnyProgram& program,
                                                       Step& step) {
    const EpisodeEnds ends = write_outcome<Graph>(program, k, step.rows);
    held_.critic.step(k, program);
    if constexpr (Staging<Graph>::kStages > 0) {
      resets_.staging.weigh(k, step.rows, [&](std::size_t i) {
        return static_cast<float>(element(program.outcome().terms, i));
      });
    }
    if constexpr (has_task<Graph>) {
      if (!ends.is_finite) [[unlikely]] {
        if (runs_single_) runs_single_ = false;  // threads of several environments only read it
        not_finite_.note(held_.episodes[k].place(k, held_.steps[k]), program.outcome());
      }
    }
    return ends;
  }

  /// False: the episode ends.
  [[gnu::always_inline]] inline bool write_ends(std::uint32_t k, EpisodeEnds ends,
                                                const eagerx_rows& rows) {
    ++held_.steps[k];
    ends.truncated = ends.truncated || (longest_ != 0 && held_.steps[k] >= longest_);
    if (rows.terminated != nullptr) rows.terminated[k] = ends.terminated ? 1 : 0;
    if (rows.truncated != nullptr) rows.truncated[k] = ends.truncated ? 1 : 0;
    return !ends.terminated && !ends.truncated;
  }

  /// write(row) writes the observation of the step.
  template <class Write>
  void end_step(std::uint32_t k, EpisodeEnds ends, Step& step, Write&& write) {
    if (!write_ends(k, ends, step.rows)) {
      end_episode(k, step, write);
    } else if (step.rows.observation != nullptr) {
      write(step.rows.observation + k * layout_.observations.numbers());
    }
  }

  template <class Write>
  void end_episode(std::uint32_t k, Step& step, Write&& write) {
    const eagerx_rows& rows = step.rows;
    Episode& episode = held_.episodes[k];
    const std::size_t observed = layout_.observations.numbers();
    if (autoreset_ == EAGERX_SAME_STEP) {
      if (rows.final_observation != nullptr) write(rows.final_observation + k * observed);
      held_.critic.end(k);
      ++episode.index;
      resets_.begin_later(held_, k, step);
    } else {
      if (rows.observation != nullptr) write(rows.observation + k * observed);
      episode.ended = true;
      held_.take_out(k);
    }
  }

  /// Replaces a step of an environment whose episode has ended.
  void stay_or_begin(std::uint32_t k, Step& step) {
    write_no_outcome<Graph>(k, step.rows);
    if (autoreset_ != EAGERX_NEXT_STEP) return;
    ++held_.episodes[k].index;
    resets_.begin_later(held_, k, step);
  }

  void require_begun() const {
    if (!all_begun_) refuse_before_reset();
  }
  [[noreturn, gnu::noinline]] void refuse_before_reset() const {
    std::uint32_t k = 0;
    while (held_.episodes[k].begun) ++k;
    refuse("environment " + std::to_string(k) + " has not begun: reset it first");
  }

  const Layout<Graph>& layout_ = Layout<Graph>::get();
  std::uint32_t longest_;
  std::uint32_t autoreset_;
  bool all_begun_ = false;
  /// One environment in its own program, within an episode: a step is its program's and writes
  /// rows.
  bool runs_single_ = false;
  Held<Graph> held_;
  Resets<Graph> resets_;
  Agents<Graph> agents_;
  NotFinite<Graph> not_finite_;
  Workload resetting_, stepping_, acting_;
  host::ThreadPool pool_;
};

}  // namespace eagerx::environments

// Many environments of one graph: their episodes, on all cores. Environment k has the same bits
// alone, in a pack, in any batch and on any number of threads.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <eagerx/random.hpp>
#include <map>
#include <memory>
#include <runtime/host/base/team.hpp>
#include <string>
#include <string_view>
#include <targets/common/run.hpp>
#include <targets/environments/agent.hpp>
#include <targets/environments/beginning.hpp>
#include <targets/environments/critic.hpp>
#include <targets/environments/episode.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/not_finite.hpp>
#include <targets/environments/pack_memory.hpp>
#include <targets/environments/pictures.hpp>
#include <targets/environments/problem.hpp>
#include <targets/environments/set_states.hpp>
#include <targets/environments/stages.hpp>
#include <targets/environments/task.hpp>
#include <targets/environments/traced.hpp>
#include <targets/environments/tuning.hpp>
#include <targets/environments/workload.hpp>
#include <utility>
#include <vector>

namespace eagerx::environments {

/// Throws Problem for what a caller did wrong, std::bad_alloc and std::system_error in its
/// constructor. Nothing is allocated behind that, but for states that are set, traces and counts.
template <class Graph>
class Batch {
 public:
  using Program = typename Graph::template Program<NoTrace>;

  /// `options` are in range; `kernel` has lanes where environments can run in packs.
  Batch(const eagerx_options& options, const PackKernel<Graph>& kernel)
      : size_(options.environments),
        longest_(options.longest),
        autoreset_(options.autoreset),
        episodes_(std::make_unique<Episode[]>(size_)),
        steps_(std::make_unique<std::uint32_t[]>(size_)),
        drawn_(options.pictures != 0 ? size_ : 0),
        programs_(std::make_unique<Program[]>(plain_programs())),
        packs_(drawn_.any() ? PackKernel<Graph>{} : kernel, size_),
        agents_(kernel),
        draws_(kernel),
        staging_(size_),
        critic_(size_),
        team_(std::min(options.threads != 0 ? options.threads : host::usable_cores(), blocks())) {
    packs_.make_room(team_.size());
    agents_.make_room(team_.size());
    if (target::is_real(programs_[0])) {
      throw Problem("engine `" + std::string(Graph::kEngine) +
                    "` moves real hardware, of which there is one: generate the library with "
                    "`--engine` and an engine that simulates");
    }
    for (std::uint32_t k = 0; k < size_; ++k) {
      episodes_[k].seed = options.seed;
      episodes_[k].number = options.numbers != nullptr ? options.numbers[k] : k;
    }
    // By all members: a library may need memory for each thread, too.
    team_.run(team_.size(), [&](unsigned i) {
      for (std::uint32_t k = i; k < size_; k += team_.size())
        with(k, [](auto& program) { target::warm_up(program); });
    });
  }
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;
  ~Batch() {
    for (std::uint32_t k = 0; k < size_; ++k)
      untraced(k, [](auto& program) { target::stop(program); });
    for (auto& [k, traces] : traces_) {
      if (traces.now) target::stop(traces.now->program);
    }
  }

  std::uint32_t size() const { return size_; }
  bool draws() const { return drawn_.any(); }

  void reset(const std::uint8_t* mask, const std::uint64_t* seeds, float* observation) {
    eagerx_rows rows{};
    rows.observation = observation;
    each_block(resets_, [&](std::uint32_t first, std::uint32_t end, unsigned /*member*/) {
      Step step(rows);
      for (std::uint32_t k = first; k < end; ++k) {
        if (mask != nullptr && mask[k] == 0) continue;
        Episode& episode = episodes_[k];
        if (seeds != nullptr) {
          episode.seed = seeds[k];
          episode.index = 0;
        } else if (episode.begun) {
          ++episode.index;
        }
        begin_later(k, step);
      }
      begin_all(step);
    });
    if (!all_begun_) {
      all_begun_ = std::all_of(episodes_.get(), episodes_.get() + size_,
                               [](const Episode& episode) { return episode.begun; });
    }
  }

  /// What is wrong with a reward that was not finite, or nothing.
  std::string step(const float* actions, const eagerx_rows& rows) {
    require_begun();
    not_finite_.begin_step();
    each_block(stepping_, [&](std::uint32_t first, std::uint32_t end, unsigned member) {
      Step step(rows);
      step_block(first, end, member, actions, step);
      begin_all(step);
    });
    for (auto& [k, traces] : traces_) {
      if (traces.now) traces.now->hand_on();
    }
    return not_finite_.is_any() ? not_finite_.text() : std::string();
  }

  /// What the graph's agent does next, for environments whose episode has not ended.
  void act(const float* observations, float* actions) {
    require_begun();
    const target::Agent agent = agent_of_graph<Graph>();
    const auto is_running = [&](std::uint32_t k) { return !episodes_[k].ended; };
    const auto act_alone = [&](std::uint32_t k, const auto& observation) {
      return with(k, [&](auto& program) {
        return target::act<Graph>(agent, episodes_[k].key(), steps_[k], observation, program);
      });
    };
    std::atomic<const char*> refused = nullptr;
    each_block(acts_, [&](std::uint32_t first, std::uint32_t end, unsigned member) {
      const Rows rows{first, end, observations, actions};
      if (const char* name = agents_.act(member, rows, is_running, act_alone)) refused = name;
    });
    if (refused != nullptr) throw no_such_float(refused);
  }

  void set_states(const std::uint8_t* mask, const float* states) {
    set_states_.set(size_, mask, states);
  }

  /// Of the next episodes; empty: the graph as it is written. Throws Problem, with nothing changed.
  void set_stage(const std::uint8_t* mask, std::string_view stage) { staging_.set(mask, stage); }

  /// Parameters of episodes that go on; NaN: as it is. Throws Problem, with nothing changed.
  void tune(const std::uint8_t* mask, const float* states) {
    require_begun();
    check_tuning<Graph>(size_, mask, states);
    for (std::uint32_t k = 0; k < size_; ++k) {
      if (mask == nullptr || mask[k] != 0) tune_one(k, states + k * layout_.states.numbers());
    }
  }

  void get_states(float* states) const {
    require_begun();
    for (std::uint32_t k = 0; k < size_; ++k)
      layout_.write(states_of(k), states + k * layout_.states.numbers());
  }

  /// What the critic of a training sees; null is not written.
  void critic(float* rows, float* final_rows) const {
    require_begun();
    critic_.read(rows, final_rows);
  }

  /// Null: ends the file. Empty: only the hash. What cannot be written leaves the old trace.
  void trace(std::uint32_t k, const char* path) {
    Traces<Graph>& traces = traces_[k];
    if (path == nullptr) {
      traces.end();
      return;
    }
    if constexpr (requires(const Program& program) { program.reset_timeouts(); }) {
      if (episodes_[k].begun)
        throw Problem("a trace of a graph with reset nodes begins before the first reset");
    }
    traces.begin(path, drawn_.any());
  }

  std::uint64_t hash(std::uint32_t k) const {
    const auto found = traces_.find(k);
    return found != traces_.end() && found->second.now ? found->second.now->program.trace.hash()
                                                       : 0;
  }

  /// Sums over all environments of what is not 0.
  std::map<std::string, std::uint64_t> counts() const {
    std::map<std::string, std::uint64_t> sums;
    const auto add = [&](const char* name, std::uint64_t count) {
      if (count != 0) sums[name] += count;
    };
    for (std::uint32_t k = 0; k < size_; ++k) {
      if (episodes_[k].packed) packs_.store(k, programs_[k]);
      untraced(k, [&](auto& program) { target::for_each_fault(program, add); });
    }
    for (const auto& [k, traces] : traces_) {
      if (traces.now) target::for_each_fault(traces.now->program, add);
    }
    not_finite_.for_each_count(add);
    return sums;
  }

  /// `pixels` [height][width][3]: what the environment showed last; white before that.
  void picture(std::uint32_t k, const picture::Image& pixels) {
    if (!drawn_.any())
      throw Problem("these environments draw nothing: set `pictures` of eagerx_options to 1");
    with(k, [&](auto& program) {
      if constexpr (requires { program.trace.paint(drawn_.painter(), pixels); })
        program.trace.paint(drawn_.painter(), pixels);
    });
  }

  bool has_threads() const { return team_.is_complete(); }

 private:
  std::uint32_t block() const { return block_of(size_, packs_.lanes()); }
  unsigned blocks() const { return (size_ + block() - 1) / block(); }

  /// f(first, end, member of the team) for all environments, by as many threads as the work is
  /// worth.
  template <class F>
  void each_block(Workload& workload, F&& f) {
    if (team_.size() == 1) return f(0U, size_, 0U);
    workload.run(team_, size_, block(), std::forward<F>(f));
  }

  /// f(program) of environment `k`.
  template <class F>
  decltype(auto) with(std::uint32_t k, F&& f) {
    return episodes_[k].traced ? f(traces_.find(k)->second.now->program)
                               : untraced(k, std::forward<F>(f));
  }
  template <class F>
  decltype(auto) untraced(std::uint32_t k, F&& f) const {
    if constexpr (has_render<Graph>) {
      if (drawn_.any()) return f(drawn_[k]);
    }
    return f(programs_[k]);
  }
  /// Where environments draw, only the one that tells what the graph has.
  std::uint32_t plain_programs() const { return drawn_.any() ? 1 : size_; }

  void step_block(std::uint32_t first, std::uint32_t end, unsigned member, const float* actions,
                  Step& rows) {
    const std::uint32_t lanes = packs_.lanes();
    if (lanes == 0) {
      for (std::uint32_t k = first; k < end; ++k) step_alone(k, actions, rows);
    } else {
      for (; first < end; first += lanes)
        step_pack(first, std::min(end, first + lanes), member, actions, rows);
    }
  }

  void step_pack(std::uint32_t first, std::uint32_t end, unsigned member, const float* actions,
                 Step& rows) {
    const std::uint64_t all = ~std::uint64_t{0} >> (64 - (end - first));
    const std::uint64_t packed = packs_.packed(first);
    if (packed != 0) take_actions(first, end, member, actions);
    const std::uint64_t alone = all & ~packed;  // a bit for each lane
    // Where an episode has ended its row stays as it is, if nothing begins there.
    if (packed != 0 && packs_.writes_rows(end - first) &&
        (alone == 0 || autoreset_ != EAGERX_DISABLED)) {
      step_whole_pack(first, alone, member, actions, rows);
      return;
    }
    if (packed != 0) packs_.step(member, first, nullptr);
    for (std::uint32_t k = first; k < end; ++k) {
      if (!episodes_[k].packed) {
        step_alone(k, actions, rows);
        continue;
      }
      const PackColumn column = packs_.column(member, k, k - first);
      packs_.show_guard(column, programs_[k]);
      write_outcome<Graph>(column, k, rows);
      weigh(k, column, rows);
      critic_.step(k, column);
      end_pack_step(k, column, ends_of<Graph>(column), rows,
                    [&](float* row) { packs_.write(column, layout_, row); });
    }
  }

  /// What the guards make of them.
  void take_actions(std::uint32_t first, std::uint32_t end, unsigned member, const float* actions) {
    std::uint64_t guarded = packs_.take(member, first, end - first, actions) & packs_.packed(first);
    for (; guarded != 0; guarded &= guarded - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(guarded));
      const std::uint32_t k = first + lane;
      const float* const row = actions + k * layout_.actions.numbers();
      packs_.put(member, lane, applied_action(programs_[k], layout_.action(row)));
    }
  }

  /// The rows of all lanes at once; then what is not the same for all.
  void step_whole_pack(std::uint32_t first, std::uint64_t alone, unsigned member,
                       const float* actions, Step& rows) {
    const PackRows pack_rows = packs_.rows_from(first, rows, steps_.get(), longest_);
    std::uint64_t notable = packs_.step(member, first, &pack_rows) | alone;
    if constexpr (PackMemory<Graph>::shows_guard()) {
      for (std::uint32_t lane = 0; lane < packs_.lanes(); ++lane) {
        if ((alone >> lane & 1U) == 0)
          packs_.show_guard(packs_.column(member, first, lane), programs_[first + lane]);
      }
    }
    constexpr bool kLooks = seen_of<Graph> + Staging<Graph>::kStages > 0;
    for (std::uint32_t lane = 0; kLooks && lane < packs_.lanes(); ++lane) {
      if ((alone >> lane & 1U) != 0) continue;
      const PackColumn column = packs_.column(member, first, lane);
      critic_.step(first + lane, column);
      weigh(first + lane, column, rows);
    }
    for (; notable != 0; notable &= notable - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(notable));
      const std::uint32_t k = first + lane;
      --steps_[k];
      if ((alone >> lane & 1U) != 0) {
        step_alone(k, actions, rows);
      } else {
        const PackColumn column = packs_.column(member, first, lane);
        const Ends ends =
            pack_rows.have_ends() ? ends_in_rows<Graph>(column, k, rows) : ends_of<Graph>(column);
        end_pack_step(k, column, ends, rows, [&](float* row) {
          if (rows.observation == nullptr) return packs_.write(column, layout_, row);
          const std::size_t observed = layout_.observations.numbers();
          const float* const written = rows.observation + k * observed;
          if (row != written) std::copy_n(written, observed, row);
        });
      }
    }
  }

  /// write(row) writes the observation of the step.
  template <class Write>
  void end_pack_step(std::uint32_t k, const PackColumn& column, Ends ends, Step& rows,
                     Write&& write) {
    if constexpr (has_task<Graph>) {
      if (!ends.is_finite) [[unlikely]]
        not_finite_.note(episodes_[k].place(k, steps_[k]), outcome_of<Graph>(column));
    }
    end_step(k, ends, rows, std::forward<Write>(write));
    if (steps_[k] >= packs_.most_steps()) take_out(k);
  }

  void weigh(std::uint32_t k, const PackColumn& column, const eagerx_rows& rows) const {
    staging_.weigh(k, rows, [&](std::size_t i) { return column.end(kTerms + i); });
  }

  void step_alone(std::uint32_t k, const float* actions, Step& rows) {
    if (episodes_[k].ended) {
      stay_or_begin(k, rows);
    } else {
      with(k, [&](auto& program) { step_one(k, program, actions, rows); });
    }
  }

  template <class AnyProgram>
  void step_one(std::uint32_t k, AnyProgram& program, const float* actions, Step& rows) {
    const std::size_t acted = layout_.actions.numbers();
    const auto observation = program.step(layout_.action(actions + k * acted));
    const Ends ends = write_outcome<Graph>(program, k, rows);
    critic_.step(k, program);
    if constexpr (Staging<Graph>::kStages > 0) {
      staging_.weigh(k, rows, [&](std::size_t i) {
        return static_cast<float>(element(program.outcome().terms, i));
      });
    }
    if constexpr (has_task<Graph>) {
      if (!ends.is_finite) [[unlikely]]
        not_finite_.note(episodes_[k].place(k, steps_[k]), program.outcome());
    }
    end_step(k, ends, rows, [&](float* row) { layout_.write(observation, row); });
  }

  /// write(row) writes the observation of the step.
  template <class Write>
  void end_step(std::uint32_t k, Ends ends, Step& rows, Write&& write) {
    Episode& episode = episodes_[k];
    const std::size_t observed = layout_.observations.numbers();
    ++steps_[k];
    ends.truncated = ends.truncated || (longest_ != 0 && steps_[k] >= longest_);
    if (rows.terminated != nullptr) rows.terminated[k] = ends.terminated ? 1 : 0;
    if (rows.truncated != nullptr) rows.truncated[k] = ends.truncated ? 1 : 0;
    if (!ends.terminated && !ends.truncated) {
      if (rows.observation != nullptr) write(rows.observation + k * observed);
      return;
    }
    if (autoreset_ == EAGERX_SAME_STEP) {
      if (rows.final_observation != nullptr) write(rows.final_observation + k * observed);
      critic_.end(k);
      ++episode.index;
      begin_later(k, rows);
    } else {
      if (rows.observation != nullptr) write(rows.observation + k * observed);
      episode.ended = true;
      take_out(k);
    }
  }

  /// In place of a step of an environment whose episode has ended.
  void stay_or_begin(std::uint32_t k, Step& rows) {
    write_no_outcome<Graph>(k, rows);
    if (autoreset_ != EAGERX_NEXT_STEP) return;
    ++episodes_[k].index;
    begin_later(k, rows);
  }

  void begin_later(std::uint32_t k, Step& step) {
    step.environments[step.waiting++] = k;
    if (step.waiting == draws_.most()) begin_all(step);
  }
  void begin_all(Step& step) {
    if (step.waiting == 0) return;
    EpisodeKey keys[Step::kMost];
    typename Graph::States states[Step::kMost];
    for (std::uint32_t i = 0; i < step.waiting; ++i)
      keys[i] = episodes_[step.environments[i]].key();
    draws_.draw(keys, step.waiting, states);
    for (std::uint32_t i = 0; i < step.waiting; ++i)
      begin(step.environments[i], states[i], step.observation);
    step.waiting = 0;
  }

  /// `states`: as the graph draws them.
  void begin(std::uint32_t k, typename Graph::States& states, float* observations) {
    Episode& episode = episodes_[k];
    set_states_.begin(k);
    staging_.begin(k);
    put_own(k, states);
    const bool goes_on = episode.packed && packs_.restarts() && !traces_.contains(k);
    if (!goes_on) take_out(k);
    const auto observation =
        goes_on ? packs_.restart(k, programs_[k], states) : reset_program(k, episode.key(), states);
    with(k, [&](const auto& program) { critic_.begin(k, program, states); });
    if (observations != nullptr)
      layout_.write(observation, observations + k * layout_.observations.numbers());
    steps_[k] = 0;
    episode.begun = true;
    episode.ended = false;
    if (packs_.lanes() != 0 && !episode.traced && !goes_on) put_in(k);
  }

  void tune_one(std::uint32_t k, const float* row) {
    const auto set = tuned_states<Graph>(row);
    const bool was_packed = episodes_[k].packed;
    take_out(k);
    if (episodes_[k].traced) {
      traces_.find(k)->second.now->tune(steps_[k], set);
    } else {
      untraced(k, [&](auto& program) { target::tune(program, set); });
    }
    if (was_packed) put_in(k);
  }

  void put_in(std::uint32_t k) {
    packs_.load(k, programs_[k]);
    episodes_[k].packed = true;
  }
  /// Back into its own program.
  void take_out(std::uint32_t k) {
    if (!episodes_[k].packed) return;
    packs_.store(k, programs_[k]);
    packs_.leave(k);
    episodes_[k].packed = false;
  }

  typename Graph::Observation reset_program(std::uint32_t k, EpisodeKey key,
                                            const typename Graph::States& states) {
    if (const auto found = traces_.find(k); found != traces_.end()) {
      if (Traced<Graph>* const traced = found->second.take()) {
        episodes_[k].traced = true;
        return traced->reset(key, states);
      }
    }
    return untraced(k, [&](auto& program) {
      if constexpr (requires { program.trace.forget(); }) program.trace.forget();
      return program.reset(states);
    });
  }

  /// That the current episode begins with.
  typename Graph::States states_of(std::uint32_t k) const {
    typename Graph::States states = Graph::draw(episodes_[k].key());
    put_own(k, states);
    return states;
  }
  /// What the stage draws otherwise than the graph, and what was set.
  void put_own(std::uint32_t k, typename Graph::States& states) const {
    staging_.draw(k, episodes_[k].key(), states);
    set_states_.read(k, states);
  }

  void require_begun() const {
    if (all_begun_) return;
    std::uint32_t k = 0;
    while (episodes_[k].begun) ++k;
    throw Problem("environment " + std::to_string(k) + " has not begun: reset it first");
  }

  const Layout<Graph>& layout_ = Layout<Graph>::get();
  std::uint32_t size_;
  std::uint32_t longest_;
  std::uint32_t autoreset_;
  bool all_begun_ = false;
  std::unique_ptr<Episode[]> episodes_;     // [size_]
  std::unique_ptr<std::uint32_t[]> steps_;  // [size_], of the episodes
  DrawnPrograms<Graph> drawn_;
  std::unique_ptr<Program[]> programs_;  // [size_], or one if `drawn_` has them
  PackMemory<Graph> packs_;
  Agents<Graph> agents_;
  Draws<Graph> draws_;
  SetStates<Graph> set_states_;
  Staging<Graph> staging_;
  CriticRows<Graph> critic_;
  std::map<std::uint32_t, Traces<Graph>> traces_;
  NotFinite<Graph> not_finite_;
  Workload resets_, stepping_, acts_;
  host::Team team_;
};

}  // namespace eagerx::environments

// What watches a run, step by step.
#pragma once

#include <cstdint>
#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>
#include <targets/common/csv.hpp>
#include <targets/common/run.hpp>
#include <targets/linux-sim/interrupt.hpp>
#include <targets/linux-sim/measures.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/pacer.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>
#include <targets/linux-sim/progress.hpp>
#include <targets/linux-sim/spaces.hpp>
#include <targets/linux-sim/split.hpp>
#include <targets/linux-sim/state_record.hpp>
#include <targets/linux-sim/state_settings.hpp>
#include <targets/linux-sim/summary.hpp>
#include <targets/linux-sim/task_record.hpp>
#include <targets/linux-sim/text_file.hpp>

namespace eagerx::linux_sim {

/// What watches a run: rows of the CSV, real time, the progress bar, Ctrl-C. Nothing here
/// allocates.
template <class Graph>
class Watch {
 public:
  using Action = typename Graph::Action;
  using Observation = typename Graph::Observation;
  using Table = target::CsvTable<Graph, TextFile>;
  using Outcome = typename Table::Outcome;

  using Link = typename LinkOf<Graph>::Type;

  using States = typename Graph::States;

  Watch(const Options& options, const StateSettings<Graph>& settings, TextFile& csv,
        TextFile& trace, Link& link)
      : settings_(settings),
        csv_states_(options.csv_states),
        csv_(csv),
        trace_(trace),
        link_(link),
        agent_(options.agent),
        pacer_(Graph::Rate::period_s, options.real_time_factor, Graph::kSafety.max_lateness_ns),
        progress_(options.plan.episodes * options.plan.steps, !options.quiet),
        steps_an_episode_(options.plan.steps),
        seed_(options.plan.seed),
        environment_(options.plan.environment),
        strict_spaces_(options.strict_spaces),
        summary_(options.summary) {}

  void begin(EpisodeKey key) {
    if constexpr (is_split<Graph>) link_.begin_episode({key, static_cast<std::uint8_t>(agent_)});
  }
  States states(EpisodeKey key) {
    States states = Graph::draw(key);
    settings_.apply(key, states);
    record_.begin(states);
    task_record_.end_episode();
    if (measures_of_run.is_used()) {
      measures_of_run.end_episode();
      measures_of_run.begin_episode();
      record_.for_each_value([](std::uint32_t number, const auto& message) {
        measures_of_run.set_message(Variable::Kind::state, number, message);
      });
    }
    if (trace_.is_open()) record_.trace(trace_, key.episode);
    return states;
  }
  /// Whether an episode is over before its last step.
  bool is_over() const { return measures_of_run.is_over(); }
  bool go_on() const {
    stop_if_told();
    if constexpr (requires { Graph::kRenders; }) {
      if (pictures_of_run.ends_run()) return false;
    }
    return !interrupted() && !csv_.failed() && !trace_.failed() && !left_space();
  }

  void reset(std::uint32_t episode, const Observation& observation) {
    pacer_.start();
    if (episode == 0) {
      began_ns_ = pacer_.start_ns();
      progress_.start(began_ns_);
    }
    ++episodes_;
    if (measures_of_run.is_used()) measures_of_run.step(0, 0.0);
    if (csv_.is_open()) {
      if (episode == 0) {
        Table::header(csv_, observation, [&](TextFile& out) {
          if (csv_states_) record_.column_names(out);
        });
      }
      row(episode, 0, observation, nullptr, nullptr);
    }
    hand_on(pacer_.is_slow());
  }

  void step(std::uint32_t episode, Seq step, const Action& action, const Observation& observation,
            const Outcome& outcome) {
    ++steps_;
    task_record_.step(outcome);
    if (measures_of_run.is_used())
      measures_of_run.step(step, Graph::Rate::template seconds<double>(step));
    if (csv_.is_open()) row(episode, step, observation, &action, &outcome);
    hand_on(step == steps_an_episode_ || is_over() || target::has_ended(outcome) ||
            pacer_.is_slow());
    progress_.step(steps_);
    if constexpr (requires { Graph::kRenders; }) {
      pacer_.pause(pictures_of_run.take_paused_ns());
      pacer_.set_speed(step, pictures_of_run.speed());
    }
    if (pacer_.paces()) pacer_.wait_for(step);
  }

  /// Whether a message has ended the run: --strict-spaces.
  bool left_space() const { return strict_spaces_ && spaces_of_run<Graph>.is_any(); }
  /// What is wrong with the first reward that was not finite, or nothing.
  std::string not_finite() const {
    const std::string first = task_record_.not_finite();
    return first.empty() ? first : not_finite_problem(first, seed_, environment_);
  }
  /// Whether there is something that a safe action could stop.
  bool has_begun() const { return episodes_ > 0; }
  std::uint64_t late_in_a_row() const { return pacer_.late_in_a_row(); }

  void finish(Summary& summary) {
    constexpr double kSecondsPerNs = 1e-9;
    progress_.finish();
    summary.episodes = episodes_;
    summary.steps = steps_;
    summary.simulated_s = static_cast<double>(steps_) * Graph::Rate::period_s;
    if (episodes_ > 0) {
      summary.elapsed_s = static_cast<double>(now_ns() - began_ns_) * kSecondsPerNs;
    }
    if (episodes_ > 0) record_.describe(summary);
    if (measures_of_run.is_used()) {
      measures_of_run.end_episode();
      measures_of_run.describe(summary);
    }
    task_record_.end_episode();
    task_record_.count(summary);
    if (summary_) task_record_.describe(summary);
    summary.paced = pacer_.paces();
    summary.overruns = pacer_.overruns();
    summary.worst_overrun_s = pacer_.worst_s();
    summary.interrupted = interrupted();
  }

 private:
  void row(std::uint32_t episode, Seq step, const Observation& observation, const Action* action,
           const Outcome* outcome) {
    Table::row(csv_, episode, step, observation, action, outcome, [&](TextFile& out) {
      if (csv_states_) record_.columns(out);
    });
  }
  void hand_on(bool now) {
    csv_.hand_on(now);
    trace_.hand_on(now);
  }

  const StateSettings<Graph>& settings_;
  StateRecord<Graph> record_;
  TaskRecord<Outcome> task_record_;
  bool csv_states_;
  TextFile& csv_;
  TextFile& trace_;
  Link& link_;
  target::Agent agent_;
  Pacer pacer_;
  Progress progress_;
  std::uint64_t steps_an_episode_;
  std::uint64_t seed_;
  std::uint32_t environment_;
  bool strict_spaces_;
  bool summary_;
  std::int64_t began_ns_ = 0;
  std::uint64_t episodes_ = 0;
  std::uint64_t steps_ = 0;
};

}  // namespace eagerx::linux_sim

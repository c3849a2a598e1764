#include <algorithm>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/supervisor.hpp>
#include <targets/linux-sim/run_watch.hpp>

namespace eagerx::linux_sim {

RunWatch::RunWatch(GraphProgram& program, const RunInputs& inputs, host::TextFile& csv,
                   host::TextFile& trace)
    : Watch(inputs.options.plan, inputs.options.agent, csv),
      facts_(program.facts()),
      inputs_(inputs),
      measures_(inputs.measures),
      spaces_(program.spaces),
      pictures_(program.pictures()),
      states_(inputs.fields.states),
      observations_(inputs.fields.observations),
      sizes_(inputs.fields.observations.size()),
      record_(inputs.fields.states),
      task_record_(inputs.fields.outcomes),
      csv_(csv),
      trace_(trace),
      pacer_(facts_.period_s(), program.is_real() ? 0.0 : inputs.options.real_time_factor,
             facts_.safety.max_lateness_ns),
      progress_(plan_.episodes * plan_.steps, !inputs.options.quiet) {
  writes_ = csv.is_open();
  paces_ = pacer_.paces();
  // A row of the table has the action.
  looks_ = measures_.reads_messages() || inputs.options.strict_spaces ||
           (facts_.part_decides && writes_);
  has_faults_ = !inputs.faults.empty();
  tunes_ = inputs.settings.tunes();
}

bool RunWatch::go_on() {
  host::stop_if_requested();
  host::send_heartbeat(episodes_, steps_);
  if (pictures_ != nullptr && pictures_->ends_run()) return false;
  return !(host::interrupted() || csv_.failed() || trace_.failed() || left_space());
}

bool RunWatch::ends_early() const {
  return has_begun() && (host::interrupted() || left_space());
}

std::uint64_t RunWatch::lateness() const {
  return pacer_.late_in_a_row();
}

bool RunWatch::begin_episode(EpisodeKey key, StateRow states) {
  const bool changed = set_states(key, states);
  is_over_ = false;
  record_.begin(states);
  task_record_.end_episode();
  if (measures_.is_used()) {
    measures_.end_episode();
    measures_.begin_episode();
    measure_states();
    is_over_ = measures_.is_over();
  }
  if (trace_.is_open()) record_.trace(trace_, key.episode);
  return changed;
}

void RunWatch::measure_states() {
  const StateRow now = record_.current();
  for (std::uint32_t i = 0; i < inputs_.fields.states.size(); ++i) {
    const MessageType& type = inputs_.fields.states[i].type;
    if (now.has_value[i])
      measures_.set_message(Variable::Kind::state, i, {now.messages[i], type.scalar, type.size});
  }
}

bool RunWatch::tune(std::uint32_t episode, Seq step, StateRow states) {
  std::fill_n(states.has_value, inputs_.fields.states.size(), false);
  if (!set_parameters(step, states)) return false;
  record_.begin(states);
  if (measures_.is_used()) measure_states();
  if (trace_.is_open()) record_.trace_set(trace_, episode, step, states);
  return true;
}

void RunWatch::reset(std::uint32_t /*episode*/) {
  pacer_.start();
  if (episodes_ == 0) {
    began_ns_ = pacer_.start_ns();
    progress_.start(began_ns_);
  }
  ++episodes_;
  if (measures_.is_used()) {
    measures_.step(0, 0.0);
    is_over_ = measures_.is_over();
  }
  hand_on(pacer_.is_slow());
}

// Part of step() in the run of every program; a call where somebody stands in between.
[[gnu::always_inline]] inline bool RunWatch::counted(Seq step, bool has_ended,
                                                     const OutcomeView& outcome) {
  ++steps_;
  task_record_.step(outcome);
  if (measures_.is_used()) {
    measures_.step(step, facts_.seconds(step));
    is_over_ = measures_.is_over();
  }
  return has_ended || step == plan_.steps || is_over_;
}

[[gnu::always_inline]] inline void RunWatch::paced(Seq step, bool has_ended) {
  hand_on(has_ended || pacer_.is_slow());
  progress_.step(steps_);
  if (pictures_ != nullptr) {
    pacer_.pause(pictures_->take_paused_ns());
    pacer_.set_speed(step, pictures_->speed());
  }
  if (pacer_.paces()) pacer_.wait_for(step);
}

bool RunWatch::count(Seq step, bool has_ended, const OutcomeView& outcome) {
  return counted(step, has_ended, outcome);
}
void RunWatch::pace(Seq step, bool has_ended) {
  paced(step, has_ended);
}
void RunWatch::step(Seq step, bool has_ended, const OutcomeView& outcome) {
  paced(step, counted(step, has_ended, outcome));
}

void RunWatch::state_column_names() {
  if (inputs_.options.csv_states) record_.column_names(csv_);
}
void RunWatch::state_columns() {
  if (inputs_.options.csv_states) record_.columns(csv_);
}

const void* RunWatch::given_action(Seq step) {
  return step < inputs_.table.size() ? inputs_.table[step] : nullptr;
}

bool RunWatch::left_space() const {
  return inputs_.options.strict_spaces && spaces_.is_any();
}

std::string RunWatch::not_finite() const {
  const std::string first = task_record_.not_finite();
  return first.empty() ? first : not_finite_problem(first, plan_.seed, plan_.environment);
}

void RunWatch::finish(Summary& summary) {
  constexpr double kSecondsPerNs = 1e-9;
  progress_.finish();
  summary.episodes = episodes_;
  summary.steps = steps_;
  summary.simulated_s = static_cast<double>(steps_) * facts_.period_s();
  if (episodes_ > 0) {
    summary.elapsed_s = static_cast<double>(now_ns() - began_ns_) * kSecondsPerNs;
    record_.describe(summary);
  }
  if (measures_.is_used()) {
    measures_.end_episode();
    measures_.describe(summary);
  }
  task_record_.end_episode();
  task_record_.count(summary);
  if (inputs_.options.summary) task_record_.describe(summary);
  summary.paced = pacer_.paces();
  summary.overruns = pacer_.overruns();
  summary.worst_overrun_s = pacer_.worst_s();
  summary.interrupted = host::interrupted();
}

void RunWatch::hand_on(bool now) {
  csv_.hand_on(now);
  trace_.hand_on(now);
}

}  // namespace eagerx::linux_sim

// Watches a run, step by step: the side that the main function sees.
#pragma once

#include <cstdint>
#include <runtime/host/base/text_file.hpp>
#include <string>
#include <targets/linux-sim/action_file.hpp>
#include <targets/linux-sim/faults.hpp>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/measures.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/pacer.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>
#include <targets/linux-sim/progress.hpp>
#include <targets/linux-sim/reconnect.hpp>
#include <targets/linux-sim/state_record.hpp>
#include <targets/linux-sim/state_settings.hpp>
#include <targets/linux-sim/summary.hpp>
#include <targets/linux-sim/task_record.hpp>
#include <targets/linux-sim/watch.hpp>

namespace eagerx::linux_sim {

/// The inputs of a run, checked and read.
struct RunInputs {
  const Options& options;
  const Fields& fields;
  const ActionTable& table;
  const StateSettings& settings;
  AgentFaults& faults;
  Reconnection& reconnection;
  Measures& measures;  // which the recorder of the program fills, too
};

class RunWatch : public Watch {
 public:
  RunWatch(GraphProgram& program, const RunInputs& inputs, host::TextFile& csv,
           host::TextFile& trace);
  virtual ~RunWatch() = default;

  bool go_on() override;
  bool link_again() override { return inputs_.reconnection.link_again(steps_); }
  bool ends_early() const override;
  bool begin_episode(EpisodeKey key, StateRow states) override;
  StateRow states() final { return states_.row(); }
  bool tune(std::uint32_t episode, Seq step, StateRow states) override;
  void reset(std::uint32_t episode) override;
  void step(Seq step, bool has_ended, const OutcomeView& outcome) override;
  void state_column_names() final;
  void state_columns() final;
  const void* given_action(Seq step) override;
  ObservationRow external_observation() override { return {}; }
  void applied(const void* /*action*/) override {}
  EpisodeKey key(EpisodeKey planned) override { return planned; }
  ObservationRow observations() final { return {observations_.data(), sizes_.data()}; }
  ObservationRow seen(Seq step) final { return inputs_.faults.seen(step, observations()); }
  void given(Seq step, void* action) override { inputs_.faults.given(step, action); }

  /// Whether a message has ended the run: --strict-spaces.
  bool left_space() const;
  /// The problem of the first reward that was not finite, or nothing.
  std::string not_finite() const;
  /// Whether there is something that a safe action could stop.
  bool has_begun() const { return episodes_ > 0; }
  void finish(Summary& summary);

 protected:
  /// Puts the values of --set into the states that an episode begins with. False: nothing.
  virtual bool set_states(EpisodeKey key, StateRow states) {
    return inputs_.settings.apply(key, states);
  }
  /// The same for tunable parameters that are set before a step.
  virtual bool set_parameters(Seq step, StateRow states) {
    return inputs_.settings.apply_at(step, states);
  }
  /// The two parts of step(), between which an external agent has its answer. A class that has more
  /// to do in one of them has its own, and its own step().
  /// Takes the results of a step. Returns whether the episode has ended.
  bool count(Seq step, bool has_ended, const OutcomeView& outcome);
  /// Waits until the end of the step.
  void pace(Seq step, bool has_ended);
  StateRow current_states() const { return record_.current(); }
  /// Between two steps.
  void time_stood_still(std::int64_t ns) { pacer_.pause(ns); }
  std::uint64_t lateness() const override;
  const Pacer& pacer() const { return pacer_; }

 private:
  bool counted(Seq step, bool has_ended, const OutcomeView& outcome);
  void paced(Seq step, bool has_ended);
  void measure_states();
  void hand_on(bool now);

  const GraphFacts& facts_;
  const RunInputs& inputs_;
  Measures& measures_;
  const SpaceCounts& spaces_;
  Pictures* pictures_;
  StateMemory states_;
  MessageRows observations_;
  std::vector<std::uint32_t> sizes_;  // [observations]
  StateRecord record_;
  TaskRecord task_record_;
  host::TextFile& csv_;
  host::TextFile& trace_;
  Pacer pacer_;
  Progress progress_;
  std::int64_t began_ns_ = 0;
  std::uint64_t episodes_ = 0;
  std::uint64_t steps_ = 0;
};

}  // namespace eagerx::linux_sim

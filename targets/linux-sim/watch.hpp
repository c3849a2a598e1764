// Watches a run, step by step: the side that programs see.
#pragma once

#include <cstdint>
#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>
#include <targets/common/run.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/table_writer.hpp>

namespace eagerx::linux_sim {

/// Rows of the table, real time, the progress bar, Ctrl-C, agents that are files. Nothing here
/// allocates.
class Watch {
 public:
  const target::RunPlan& plan() const { return plan_; }
  target::Agent agent() const { return agent_; }

  virtual bool go_on() = 0;
  /// Between two episodes: reconnects lost parts. False: the run ends.
  virtual bool link_again() = 0;
  /// Whether the run has begun and ends early, so that hardware may have to be made safe.
  virtual bool ends_early() const = 0;
  /// An episode begins with `states`, as the graph samples them. True: some are others now.
  virtual bool begin_episode(EpisodeKey key, StateRow states) = 0;
  /// Memory for them.
  virtual StateRow states() = 0;
  /// Whether parameters may be set while an episode runs.
  bool tunes() const { return tunes_; }
  /// Stores the settings before step `step` (from 0) in `states`. False if there are none.
  virtual bool tune(std::uint32_t episode, Seq step, StateRow states) = 0;
  virtual void reset(std::uint32_t episode) = 0;
  virtual void step(Seq step, bool has_ended, const OutcomeView& outcome) = 0;
  /// Whether an episode ends before its last step.
  bool is_over() const { return is_over_; }
  /// Whether messages of a step are looked at before the next step, so that all must be there.
  bool looks() const { return looks_; }
  std::uint64_t late_in_a_row() const { return paces_ ? lateness() : 0; }

  /// Null: there is no table. Its rows are written before reset() and step().
  TableWriter* table() { return writes_ ? &writer_ : nullptr; }
  /// The last columns of a row: their names, or their values.
  virtual void state_column_names() = 0;
  virtual void state_columns() = 0;

  /// The action of a file, null after its end, or of another process: an agent over DDS receives
  /// observations().
  virtual const void* given_action(Seq step) = 0;

  /// Whether an external agent receives observations and applied actions, before reset() and
  /// step().
  bool has_external_agent() const { return agent_ == kExternalAgent; }
  virtual ObservationRow external_observation() = 0;
  virtual void applied(const void* action) = 0;
  /// The key of an episode that is planned with another one.
  virtual EpisodeKey key(EpisodeKey planned) = 0;

  bool has_faults() const { return has_faults_; }
  /// Memory for the observations without faults, or for an agent in another process.
  virtual ObservationRow observations() = 0;
  /// The agent's view of them; valid until the next call.
  virtual ObservationRow seen(Seq step) = 0;
  /// Replaces its action.
  virtual void given(Seq step, void* action) = 0;

 protected:
  Watch(const target::RunPlan& plan, target::Agent agent, host::TextFile& table)
      : plan_(plan), agent_(agent), writer_(table) {}
  ~Watch() = default;
  virtual std::uint64_t lateness() const = 0;

  target::RunPlan plan_;
  target::Agent agent_;
  TableWriter writer_;
  bool writes_ = false;
  bool is_over_ = false;
  bool looks_ = false;
  bool paces_ = false;
  bool has_faults_ = false;
  bool tunes_ = false;
};

}  // namespace eagerx::linux_sim

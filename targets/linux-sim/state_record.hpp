// The states and delays that the episodes of a run begin with, for table, trace and summary.
#pragma once

#include <cstddef>
#include <cstdint>
#include <runtime/host/base/text_file.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/summary.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Nothing of it allocates but the constructor and describe().
class StateRecord {
 public:
  explicit StateRecord(const std::vector<Field>& states);

  /// An episode begins, or parameters are set while it runs. What `states` does not have stays as
  /// it was.
  void begin(StateRow states);
  /// The last set value.
  StateRow current() const { return current_.row(); }

  /// Lines `# state EPISODE NAME VALUE,…`, which are no messages: the hash does not see them.
  void trace(host::TextFile& out, std::uint32_t episode) const;
  /// Lines `# set EPISODE STEP NAME VALUE,…` of what `states` has, which was set before that step.
  void trace_set(host::TextFile& out, std::uint32_t episode, Seq step, StateRow states) const;
  void column_names(host::TextFile& out) const;
  void columns(host::TextFile& out) const;
  /// A line for each state: its value, or from where to where it was sampled.
  void describe(Summary& summary) const;

 private:
  void values(host::TextFile& out, std::size_t state, const char* before) const;

  const std::vector<Field>& states_;
  StateMemory current_;
  std::vector<double> least_, most_;  // of all elements
};

/// Puts what a log says of its episode's states into `row`.
void repeat_states(const trace_log::Log& log, std::uint32_t episode,
                   const std::vector<Field>& states, StateRow row);
/// The same of what was set before a step. False: nothing was.
bool repeat_settings(const trace_log::Log& log, std::uint32_t episode, Seq step,
                     const std::vector<Field>& states, StateRow row);

}  // namespace eagerx::linux_sim

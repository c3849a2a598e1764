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

/// Only the constructor and describe() allocate.
class StateRecord {
 public:
  explicit StateRecord(const std::vector<Field>& states);

  /// Begins an episode, or sets parameters during it. States without a value are unchanged.
  void begin(StateRow states);
  /// The last set value.
  StateRow current() const { return current_.row(); }

  /// Lines `# state EPISODE NAME VALUE,…`, which are no messages: the hash does not see them.
  void trace(host::TextFile& out, std::uint32_t episode) const;
  /// Lines `# set EPISODE STEP NAME VALUE,…` for the values in `states`, which were set before that
  /// step.
  void trace_set(host::TextFile& out, std::uint32_t episode, Seq step, StateRow states) const;
  void column_names(host::TextFile& out) const;
  void columns(host::TextFile& out) const;
  /// A line for each state: its value, or the range of its samples.
  void describe(Summary& summary) const;

 private:
  void values(host::TextFile& out, std::size_t state, const char* before) const;

  const std::vector<Field>& states_;
  StateMemory current_;
  std::vector<double> least_, most_;  // of all elements
};

/// Copies the states of an episode in a log into `row`.
void repeat_states(const trace_log::Log& log, std::uint32_t episode,
                   const std::vector<Field>& states, StateRow row);
/// The same for parameters that were set before a step. False if none was.
bool repeat_settings(const trace_log::Log& log, std::uint32_t episode, Seq step,
                     const std::vector<Field>& states, StateRow row);

}  // namespace eagerx::linux_sim

// Settings under `safety:` of a graph.
#pragma once

#include <cstdint>

namespace eagerx {

/// When the safe action replaces the agent's. Counts are consecutive instants: steps of the
/// environment, slots of a paced board, ticks of an engine of real hardware.
struct Safety {
  bool declared;                 // without it nothing checks observations and actions
  std::uint32_t late;            // instants in a row later than max_lateness_ns; at least 1
  std::int64_t max_lateness_ns;  // in real time only
  std::int64_t link_timeout_ns;  // without an answer; for engines of real hardware
  std::int64_t
      heartbeat_timeout_ns;  // without a heartbeat of a program that drives hardware; 0: for ever
  std::uint32_t missed;      // instants in a row without a valid value; at least 1
  std::uint32_t
      recover;  // valid instants in a row that end the safe action; 0: only a reset ends it
  bool clips;   // an action out of its space: true: is moved into it; false: the safe action
  bool holds;   // after NaN: true: the last action for `missed` - 1 instants; false: safe at once
};

/// Number of consecutive late instants, computed just before an action is applied. `in_a_row`:
/// consecutive instants that began too late, up to the latest one; `age`: time since the latest one
/// was due. Its action is in time within a period, or within `max_lateness` if that is longer. A
/// program that hung for many periods has missed that many instants, not one. All times have the
/// same unit; `period` is above 0.
constexpr std::uint64_t late_instants(std::uint64_t in_a_row, std::uint64_t age,
                                      std::uint64_t period, std::uint64_t max_lateness) {
  const std::uint64_t longest = period > max_lateness ? period : max_lateness;
  if (age <= longest) return in_a_row;
  return (in_a_row > 0 ? in_a_row : 1) + (age - longest) / period;
}

}  // namespace eagerx

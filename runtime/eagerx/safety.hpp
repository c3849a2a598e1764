// What a graph declares under `safety:`.
#pragma once

#include <cstdint>

namespace eagerx {

/// When the safe action takes the agent's place. Counts are instants in a row: steps of the
/// environment, slots of a paced board, ticks of an engine of real hardware.
struct Safety {
  bool declared;                 // without it nothing checks observations and actions
  std::uint32_t late;            // so many instants later than max_lateness_ns; at least 1
  std::int64_t max_lateness_ns;  // in real time only
  std::int64_t link_timeout_ns;  // without an answer; for engines of real hardware
  std::uint32_t missed;          // so many instants without a valid value; at least 1
  std::uint32_t recover;  // so many right instants end the safe action; 0: only a reset ends it
  bool clips;  // an action out of its space: true: is moved into it; false: the safe action
  bool holds;  // after NaN: true: the last action for `missed` - 1 instants; false: safe at once
};

}  // namespace eagerx

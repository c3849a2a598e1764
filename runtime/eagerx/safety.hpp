// What a graph declares under `safety:`.
#pragma once

#include <cstdint>

namespace eagerx {

/// When the safe action takes the agent's place. Counts are instants in a row: steps of the
/// environment, slots of a paced board, ticks of an engine of real hardware.
struct Safety {
  bool declared;                 // without it nothing checks observations and actions
  std::uint32_t late;            // later than max_lateness_ns: makes safe; at least 1
  std::int64_t max_lateness_ns;  // in real time only
  std::int64_t link_timeout_ns;  // without an answer: makes engines of real hardware safe
  std::uint32_t missed;          // without a valid value: makes safe; at least 1
  std::uint32_t recover;         // right: ends the safe action; 0: only a reset does
  bool clips;                    // an action out of its space is moved into it, else makes safe
  bool holds;  // NaN: the action before for `missed` - 1 instants in a row, else safe at once
};

}  // namespace eagerx

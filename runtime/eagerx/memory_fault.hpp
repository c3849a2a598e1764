// Reaction to corrupted memory: a bit has flipped, or something has overwritten the program's data.
#pragma once

/// Called, if defined, when a program finds an invalid place in the schedule. It may end the
/// program, as on boards; if it returns, or is not defined, the program counts the fault.
extern "C" [[gnu::weak]] void eagerx_memory_fault();

namespace eagerx {

[[gnu::cold]] inline void tell_memory_fault() {
  if (eagerx_memory_fault != nullptr) eagerx_memory_fault();
}

}  // namespace eagerx

// A hardware.h that is filled in, for any graph: measurements that depend on the number of the
// step alone, one that fails, one that takes 2.2 periods, with HANG one that takes for ever. With
// OPTIONAL it has all that it may have.
#pragma once

#include GRAPH_HEADER

#include <bit>
#include <cstdint>
#include <eagerx/step_times.hpp>

#include "script.hpp"
#include "world.hpp"

namespace hardware {

namespace graph = GRAPH_NAMESPACE;

// NAMES

inline std::uint64_t step = 0;

#ifdef OPTIONAL
inline void begin(eagerx::ResetReason reason) {
  std::printf("begin after reset %d\n", static_cast<int>(reason));
}
inline bool armed() {
  return script::is_armed(step);
}
inline bool reset_requested() {
  return step == script::kReset;
}
template <class Guard, class StepTimes>
void report(const Guard& guard, const StepTimes& times) {
  script::print_counts(step - 1, guard, script::late_steps(times));
}
#else
inline void begin() {
  std::printf("begin\n");
}
#endif

inline graph::Action read_measurements() {
  world::pass(script::reading_us<graph::Graph::Rate>(step));
  return script::measured<graph::Graph>(step);
}

inline void apply_outputs(const graph::Observation& outputs) {
  if (step == script::kSteps) std::exit(0);
  script::print(step++, outputs);
}

}  // namespace hardware

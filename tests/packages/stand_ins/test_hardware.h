// A hardware.h that is filled in, for any graph: measurements that depend on the number of the
// step alone, one that fails, one that takes 2.2 periods, with HANG one that takes for ever.
#pragma once

#include GRAPH_HEADER

#include <bit>
#include <cstdint>
#include <eagerx/step_times.hpp>

#include "script.hpp"
#include "world.hpp"

namespace hardware {

namespace graph = GRAPH_NAMESPACE;

inline std::uint64_t step = 0;

inline void begin() {
  std::printf("begin\n");
}

inline graph::Action read_measurements() {
  world::pass(script::reading_us<graph::Graph::Rate>(step));
  return script::measured<graph::Graph>(step);
}

inline void apply_outputs(const graph::Observation& outputs) {
  script::print(step, outputs);
  if (++step == script::kSteps) std::exit(0);
}

}  // namespace hardware

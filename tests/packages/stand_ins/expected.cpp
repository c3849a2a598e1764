// Prints the expected output of every main loop: a handwritten loop with a given lateness.
#include GRAPH_HEADER

#include <optional>

#include "script.hpp"

namespace graph = GRAPH_NAMESPACE;

template <class Graph>
graph::Action action_of(std::uint64_t step, const graph::Observation& seen) {
  if constexpr (Graph::kHasPolicy) {
    return Graph::policy(seen);
  } else {
    return script::measured<Graph>(step);
  }
}

int main(int /*argc*/, char** argv) {
  static graph::Program<> program;
#ifdef OPTIONAL
  constexpr bool kOptional = true;
  std::printf("begin after reset %d\n", static_cast<int>(eagerx::ResetReason::watchdog));
#else
  constexpr bool kOptional = false;
  std::printf("begin\n");
#endif
  std::printf("watchdog %s ms\n", argv[1]);
  std::optional<graph::Observation> seen = program.reset({});
  for (std::uint64_t step = 0; step < script::kSteps; ++step) {
    const bool is_armed = !kOptional || script::is_armed(step);
    const bool becomes_armed = is_armed && step > 0 && !script::is_armed(step - 1);
    if (kOptional && (becomes_armed || step == script::kReset)) seen = program.reset({});
    const graph::Action action = action_of<graph::Graph>(step, *seen);
    // 2.2 periods are one and a part of another more than a step may take, which is one; the next
    // step was due 1.2 periods before.
    const bool reads = !graph::Graph::kHasPolicy;
    const std::uint64_t late = !reads                      ? 0
                               : step == script::kSlow     ? 2
                               : step == script::kSlow + 1 ? 1
                                                           : 0;
    seen = is_armed ? program.step(action, late) : program.step_safely();
    script::print(step, *seen);
    if (kOptional) script::print_counts(step, program.guard, reads && step > script::kSlow);
  }
}

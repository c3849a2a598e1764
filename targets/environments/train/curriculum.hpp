// Position of a training in the stages of its task.
#pragma once

#include <cstdint>

namespace eagerx::train {

/// Each stage begins a new era, so that all its episodes belong to the stage, and a checkpoint does
/// not depend on earlier stages. Without stages, there is one that began at the start.
struct Curriculum {
  std::uint32_t stage = 0;  // of the task; behind the last one: the graph as it is written
  std::uint32_t began = 0;  // in this iteration
  std::uint32_t eras = 0;   // that had begun before it

  /// The next stage begins with `iteration`, which begins an era, too.
  void go_on(std::uint32_t iteration, std::uint32_t era) {
    ++stage;
    began = iteration;
    eras = era;
  }
};

}  // namespace eagerx::train

// Several trainings in parallel.
#pragma once

#include <cstddef>
#include <functional>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

/// How many trainings run at once, and with how many threads each. Their bits depend on neither.
struct ParallelRuns {
  unsigned at_once, threads;
};

/// For `count` of them: as many as there are threads, which share what is left over. A library that
/// cannot be stepped by several threads at once has one training at a time.
ParallelRuns parallel_runs(const Options& options, const Library& library, std::size_t count);

/// train(i, stop) for 0 … count - 1, each once, `at_once` of them in parallel. Once one throws, the
/// others must stop and no more begin; throws what the first of them has thrown.
/// Of an interrupted one no more begin than the first, which says so itself.
void train_in_parallel(std::size_t count, unsigned at_once, const Interrupt& is_interrupted,
                       const std::function<void(std::size_t, const Stop&)>& train);

}  // namespace eagerx::train

// Several trainings in parallel.
#pragma once

#include <cstddef>
#include <functional>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

/// How many trainings run in parallel, and with how many threads each. Bits depend on neither.
struct ParallelRuns {
  unsigned at_once, threads;
};

/// For `count` trainings: one for each thread; remaining threads are shared. A library that several
/// threads cannot step in parallel runs one training at a time.
ParallelRuns parallel_runs(const Options& options, const Library& library, std::size_t count);

/// train(i, stop) for 0 … count - 1, each once, `at_once` of them in parallel. Once one throws, the
/// others must stop and no more begin; rethrows the first exception. After an interrupt, only the
/// first begins, which reports it.
void train_in_parallel(std::size_t count, unsigned at_once, const Interrupt& is_interrupted,
                       const std::function<void(std::size_t, const Stop&)>& train);

}  // namespace eagerx::train

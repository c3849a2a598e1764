#include "targets/environments/train/parallel_runs.hpp"

#include <algorithm>

#include "targets/environments/train/start.hpp"

namespace eagerx::train {

ParallelRuns parallel_runs(const Options& options, const Library& library, std::size_t count) {
  const unsigned threads = chosen_threads(options.threads);
  if (!library.description().has_threads) return {1, threads};
  const auto at_once = static_cast<unsigned>(std::clamp<std::size_t>(count, 1, threads));
  return {at_once, threads / at_once};
}

void train_in_parallel(std::size_t count, unsigned at_once, const Interrupt& is_interrupted,
                       const std::function<void(std::size_t, const Stop&)>& train) {
  Interrupt has_failed = false;
  const Stop stop(is_interrupted, has_failed);
  ThreadPool pool(at_once, ThreadPool::Size::at_most);
  pool.run_parts(count, [&](std::size_t i) {
    if (stop && i != 0) return;
    try {
      train(i, stop);
    } catch (...) {
      has_failed = true;
      throw;
    }
  });
}

}  // namespace eagerx::train

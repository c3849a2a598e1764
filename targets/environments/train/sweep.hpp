// A sweep: trainings with different settings.
#pragma once

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

/// Trains with each of options.cases and each seed in parallel, except for those in the file of
/// results. Writes results, table and the policy of the best training. Returns an exit code: 0 once
/// all are complete, with or without success. Throws Problem.
int train_sweep(const Options& options, const Library& library, const Interrupt& is_interrupted);

/// Throws Problem as check_files() does.
void check_files_of_sweep(const Options& options);

}  // namespace eagerx::train

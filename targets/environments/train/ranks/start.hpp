// Starts a training on the ranks of MPI.
#pragma once

#include "targets/environments/ranks/ranks.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

using environments::Ranks;

/// In rank 0, after its own checks: throws Problem for options that several ranks cannot share;
/// otherwise sends its command line, the library and the checkpoint to the other ranks, which need
/// no files.
void give(Ranks& ranks, int argc, const char* const* argv, const Options& options);
/// In rank 0, if there is nothing to do.
void give_nothing(Ranks& ranks);
/// In the other ranks: the options of a quiet training; no library if there is nothing to do.
Options take_job(Ranks& ranks);

/// In all ranks: trains. An exit code. Throws Problem, in all of them if it can, before any step.
int train_together(Ranks& ranks, const Options& options, const Interrupt& is_interrupted);

}  // namespace eagerx::train

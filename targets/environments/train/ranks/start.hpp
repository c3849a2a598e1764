// Starts a training on the ranks of MPI.
#pragma once

#include "targets/environments/ranks/ranks.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

using environments::Ranks;

/// In rank 0, behind its own checks: throws Problem for what several ranks cannot share, else gives
/// its command line, the library and what it continues from to the other ranks, which need no
/// files.
void give(Ranks& ranks, int argc, const char* const* argv, const Options& options);
/// In rank 0, if there is nothing to do.
void give_nothing(Ranks& ranks);
/// In the others: what they train, quietly; no library if there is nothing to do.
Options take_job(Ranks& ranks);

/// In all ranks: trains. An exit code. Throws Problem, in all of them if it can, before any step.
int train_together(Ranks& ranks, const Options& options, const Interrupt& is_interrupted);

}  // namespace eagerx::train

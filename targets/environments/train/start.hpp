// Makes a training from options and library. Errors are reported before the first step.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "targets/environments/ranks/ranks.hpp"
#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/kernels.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

using environments::Ranks;

/// Throws Problem if a file of the options could not be written or read.
void check_files(const Options& options);

/// The description, if one can train on it. Throws Problem.
const Description& checked(const Library& library);

/// Empty: the fastest of this machine. Throws Problem if it has none of that name.
const Kernels& chosen_kernels(const std::string& name);

/// 0: one for each core.
unsigned chosen_threads(unsigned threads);

/// With several ranks, it has been checked that they can share it: ranks/start.hpp.
std::unique_ptr<Algorithm> chosen_algorithm(Settings settings, const Library& library,
                                            const Kernels& kernels, ThreadPool& pool, Ranks& ranks);

}  // namespace eagerx::train

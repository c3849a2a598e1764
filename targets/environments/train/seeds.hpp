// Several trainings that differ in their seed only.
#pragma once

#include <string>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"

namespace eagerx::train {

/// Trains with the seeds settings.seed … + seeds - 1, in parallel. Each writes its own policy and
/// checkpoint, the best policy is also that of --output; curve and table contain all. Returns an
/// exit code: 0 if all have succeeded. Throws Problem as Training does.
int train_seeds(const Options& options, const Library& library, const Interrupt& is_interrupted);

/// "policy.safetensors", 3 → "policy.seed3.safetensors".
std::string path_of_seed(const std::string& path, std::uint64_t seed);

/// Throws Problem as check_files() does, for the files of all seeds.
void check_files_of_seeds(const Options& options);

}  // namespace eagerx::train

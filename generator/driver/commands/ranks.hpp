// Commands that mpirun starts several times: eagerx-gen campaign, eagerx-gen train.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/driver/pipeline/options.hpp"
#include "generator/support/process/process.hpp"

namespace eagerx::gen {

/// Like exec_with_environments(), for the program and its checker of this name. If mpirun has
/// started several ranks, it executes NAME-mpi; rank 0 builds the library and sends everything to
/// the others. `words`, called in rank 0 only, fills in the arguments of the program; if its exit
/// code is not 0, the command ends with it. `explain`: as in Helper.
int exec_in_ranks(const std::string& name, const GenerateOptions& options,
                  const std::function<int(std::vector<std::string>&)>& words,
                  const std::function<int(const ProcessResult& checked)>& explain = {});

}  // namespace eagerx::gen

// Commands that mpirun starts several times: eagerx-gen campaign, eagerx-gen train.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/driver/pipeline/options.hpp"
#include "generator/support/process/process.hpp"

namespace eagerx::gen {

/// As exec_with_environments(), for the program and its checker of this name. Where mpirun has
/// started several ranks it becomes NAME-mpi; rank 0 builds the library, and the others get all
/// from there. `words`, asked in rank 0 only, fills in the arguments of the program; an exit code
/// other than 0 is that of the command. `explain`: as in Helper.
int exec_in_ranks(const std::string& name, const GenerateOptions& options,
                  const std::function<int(std::vector<std::string>&)>& words,
                  const std::function<int(const ProcessResult& checked)>& explain = {});

}  // namespace eagerx::gen

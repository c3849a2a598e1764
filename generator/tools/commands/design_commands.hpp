// The commands of `eagerx-gen design`, one for each method.
#pragma once

#include "generator/driver/commands/arguments.hpp"
#include "generator/tools/commands/design_run.hpp"

namespace eagerx::gen {

/// Options of all of them; `types`: of the node that is designed.
Arguments design_arguments(DesignOptions& options, std::string types);

Command design_lqr_command();
Command design_kalman_command();
Command design_pid_command();

}  // namespace eagerx::gen

// `--replay`: repeats the run of a log.
#pragma once

#include <targets/linux-sim/action_file.hpp>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

/// Exit code 0 if nothing differs, 1 if something does.
int replay_log(const Options& options, const Fields& fields, const ActionTable& table,
               GraphProgram& program);

}  // namespace eagerx::linux_sim

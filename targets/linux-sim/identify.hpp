// `--identify`: the program repeats a log with the trials of runtime/host/identify.
#pragma once

#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

/// Finds parameters and delays of the run of a log; returns the exit code.
int identify(const Options& options, const Fields& fields, GraphProgram& program);

}  // namespace eagerx::linux_sim

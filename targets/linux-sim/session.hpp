// One run of a program: its files, its summary and its end.
#pragma once

#include <targets/linux-sim/dds/remote_agent.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/run_watch.hpp>

namespace eagerx::linux_sim {

/// Runs with everything checked and read; writes files and summary. `agent`: null, or where actions
/// come from. Returns the exit code.
int run_session(const RunInputs& inputs, GraphProgram& program, RemoteAgent* agent);

}  // namespace eagerx::linux_sim

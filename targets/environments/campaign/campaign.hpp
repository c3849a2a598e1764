// A campaign from its first chunk to its report.
#pragma once

#include <runtime/host/base/interrupt.hpp>

#include "targets/environments/campaign/options.hpp"
#include "targets/environments/client/library.hpp"
#include "targets/environments/ranks/ranks.hpp"

namespace eagerx::campaign {

using environments::Ranks;

/// Runs the missing chunks, each rank its share; rank 0 prints the report. Returns the exit code.
/// Checks `interrupted` between chunks. Throws Problem.
int run_campaign(const Options& options, const client::Library& library, Ranks& ranks,
                 const host::Interrupt& interrupted);

/// Throws Problem if a file of the options could not be written or read.
void check_files(const Options& options);

}  // namespace eagerx::campaign

// Reports that the system has no more memory or threads.
#pragma once

namespace eagerx::host {

/// From now on it says so, makes safe and ends with exit code 3, as where a file cannot be written;
/// it would be aborted otherwise.
void end_when_exhausted();

}  // namespace eagerx::host

// Reports that the system has no more memory or threads.
#pragma once

namespace eagerx::host {

/// Makes the program report exhaustion, make hardware safe and end with exit code 3, as if a file
/// cannot be written, instead of aborting.
void end_when_exhausted();

}  // namespace eagerx::host

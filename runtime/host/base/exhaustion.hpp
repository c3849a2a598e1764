// What a program does when the system has no more memory or threads for it.
#pragma once

namespace eagerx::host {

/// From now on it says so, makes safe and ends with `exit_code`; it would be aborted otherwise.
void end_when_exhausted(int exit_code);

}  // namespace eagerx::host

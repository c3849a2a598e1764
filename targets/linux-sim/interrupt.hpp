// Ctrl-C ends a run after the current step, or slot of a reset that waits for something.
#pragma once

namespace eagerx::linux_sim {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag, and a closed pipe is a write error. A
/// second SIGINT ends the program at once.
void catch_interrupts();

/// True after one of them.
bool interrupted();

}  // namespace eagerx::linux_sim

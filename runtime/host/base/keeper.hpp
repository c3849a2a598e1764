// A process beside a program that drives hardware: it makes that safe if the program is killed.
#pragma once

#include <sys/types.h>

namespace eagerx::host {

/// As long as it lives. What no handler of signals sees (SIGKILL, or no memory left) leaves outputs
/// as they were: an adapter holds its last voltage. Then the other process, which waited for this,
/// calls `make_safe(context)` in its copy of the program as it was here, and ends. It is in a
/// session of its own, and no signal but SIGKILL ends it. To be made before hardware is opened.
class Keeper {
 public:
  /// nullptr: there is nothing to make safe.
  Keeper(void (*make_safe)(void*), void* context);
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  /// All is safe: it is not needed any more.
  ~Keeper();

 private:
  pid_t process_ = -1;
  int line_ = -1;  // it waits for a byte, or for the end of this process
};

}  // namespace eagerx::host

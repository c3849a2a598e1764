// A process that supervises a program that drives hardware: it makes the hardware safe if the
// program is killed or hangs.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace eagerx::host {

/// As long as it lives. What no handler of signals sees (SIGKILL, SIGSTOP, a loop without an end)
/// leaves outputs as they were: an adapter holds its last voltage. The other process waits for it,
/// ends a program that sends no heartbeat for too long, calls `take_over(context)` in its copy
/// of the program as it was here, and ends. It is in a session of its own, and no signal but
/// SIGKILL ends it. To be made before hardware is opened; there is one at a time.
class Supervisor {
 public:
  /// Makes safe. False: it could not.
  using TakeOver = bool (*)(void*);

  /// nullptr: there is nothing to make safe. `most_silent_ns`: how long the program may give no
  /// heartbeat, from the first one on; 0: for ever. It is noticed at most a sixteenth later.
  Supervisor(TakeOver take_over, void* context, std::int64_t most_silent_ns);
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;
  /// All is safe: it is not needed any more.
  ~Supervisor();

 private:
  pid_t process_ = -1;
  int line_ = -1;  // it waits for a byte, or for the end of this process
};

// Heartbeats, for the main thread. They cost a nanosecond, and nothing without a supervisor.

/// Reports the number of finished steps and episodes. The first of these signs begins the watch.
void send_heartbeat(std::uint64_t episodes, std::uint64_t steps);
/// The program continues.
void send_heartbeat();
/// It waits on purpose until then on CLOCK_MONOTONIC.
void say_asleep_until(std::int64_t ns);

/// As long as it lives, the program may stand still: it is safe.
class WatchdogPause {
 public:
  WatchdogPause();
  WatchdogPause(const WatchdogPause&) = delete;
  WatchdogPause& operator=(const WatchdogPause&) = delete;
  ~WatchdogPause();
};

}  // namespace eagerx::host

extern "C" {
/// say_asleep_until(), for clocks of hardware, which know nothing of targets.
void eagerx_sleeps_until(std::int64_t ns);
}

// A process that supervises a program that drives hardware: it makes the hardware safe if the
// program is killed or hangs.
#pragma once

#include <sys/types.h>

#include <cstdint>

namespace eagerx::host {

/// Supervises the program during its lifetime. Events that no signal handler sees (SIGKILL,
/// SIGSTOP, an endless loop) leave outputs unchanged: an adapter holds its last voltage. The other
/// process waits for such an event, kills a program without a heartbeat for too long, calls
/// `take_over(context)` in its copy of the program at this point, and ends. It has its own session,
/// and only SIGKILL ends it. Create it before opening hardware; only one may exist at a time.
class Supervisor {
 public:
  /// Makes safe. False: it could not.
  using TakeOver = bool (*)(void*);

  /// nullptr: nothing to make safe. `most_silent_ns`: the maximum time without a heartbeat, after
  /// the first one; 0: forever. Detected at most a sixteenth later.
  Supervisor(TakeOver take_over, void* context, std::int64_t most_silent_ns);
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;
  /// Ends the supervisor, because everything is safe.
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

/// During its lifetime, the program may hang, because it is safe.
class WatchdogPause {
 public:
  WatchdogPause();
  WatchdogPause(const WatchdogPause&) = delete;
  WatchdogPause& operator=(const WatchdogPause&) = delete;
  ~WatchdogPause();
};

}  // namespace eagerx::host

extern "C" {
/// say_asleep_until(), for clocks of hardware, which do not depend on targets.
void eagerx_sleeps_until(std::int64_t ns);
}

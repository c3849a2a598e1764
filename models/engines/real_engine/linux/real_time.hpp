// Real-time scheduling on Linux, where that is allowed.
#pragma once

#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace eagerx::models {

/// Locks the program's memory, and gives it real-time priority `priority` (SCHED_FIFO), unless that
/// is 0. Missing permissions are reported once, and the program continues.
inline void ask_for_real_time(int priority) {
  const auto say = [](const char* what, const char* help) {
    static_cast<void>(
        std::fprintf(stderr, "note: %s (%s); as root, or %s\n", what, std::strerror(errno), help));
  };
  if (priority <= 0) return;
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    say("memory is not locked, a page fault may delay an instant", "raise `ulimit -l`");
  }
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (sched_setscheduler(0, SCHED_FIFO, &parameters) != 0) {
    say("no real-time priority, other programs may delay an instant", "raise `ulimit -r`");
  }
}

}  // namespace eagerx::models

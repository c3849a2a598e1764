// Threads other than the one that steps.
#pragma once

#include <csignal>
#include <thread>
#include <utility>

namespace eagerx::host {

/// Threads created during its lifetime receive only signals of their own crashes: all others go to
/// the thread that sleeps until the next step.
class NoSignals {
 public:
  NoSignals() {
    sigset_t all;
    sigfillset(&all);
    for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGSYS, SIGABRT})
      sigdelset(&all, crash);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// Runs `work` in such a thread. Throws std::system_error if the system has no more.
template <class Work>
std::thread thread_without_signals(Work work) {
  const NoSignals inherited;
  return std::thread(std::move(work));
}

}  // namespace eagerx::host

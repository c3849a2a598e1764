// Threads beside the one that steps.
#pragma once

#include <csignal>
#include <thread>
#include <utility>

namespace eagerx::host {

/// Runs `work` in a thread that gets no signals but those of its own crashes: they are for the one
/// that sleeps until the next step.
template <class Work>
std::thread thread_without_signals(Work work) {
  sigset_t all, before;
  sigfillset(&all);
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGSYS, SIGABRT}) sigdelset(&all, crash);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(work));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace eagerx::host

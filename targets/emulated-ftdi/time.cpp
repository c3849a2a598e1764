// The clock, and its functions of the C library as the program finds them first.
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <targets/emulated-ftdi/emulator.hpp>
#include <targets/emulated-ftdi/time.hpp>

namespace eagerx::emulated {
namespace {

timespec to_timespec(std::int64_t ns) {
  return {static_cast<time_t>(ns / kNsPerSecond), static_cast<long>(ns % kNsPerSecond)};
}

}  // namespace

std::int64_t Time::now_ns() const {
  if (emulated_) return now_ns_;
  timespec now{};
  syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kNsPerSecond + now.tv_nsec;
}

std::int64_t Time::look() {
  constexpr std::int64_t kLook = 40;
  if (emulated_) now_ns_ += kLook;
  return now_ns();
}

void Time::wait_until(std::int64_t ns) {
  if (emulated_) {
    now_ns_ = std::max(now_ns_, ns);
    return;
  }
  const timespec until = to_timespec(ns);
  syscall(SYS_clock_nanosleep, CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

}  // namespace eagerx::emulated

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) {
  if (clock != CLOCK_MONOTONIC) return static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  *time = eagerx::emulated::to_timespec(eagerx::emulated::emulator().time().look());
  return 0;
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* until, timespec* left) {
  using eagerx::emulated::emulator;
  if (clock != CLOCK_MONOTONIC || flags != TIMER_ABSTIME) {
    return syscall(SYS_clock_nanosleep, clock, flags, until, left) == 0 ? 0 : errno;
  }
  const std::int64_t wanted =
      static_cast<std::int64_t>(until->tv_sec) * eagerx::emulated::kNsPerSecond + until->tv_nsec;
  if (emulator().time().emulated()) {
    const std::int64_t longer = emulator().oversleep_ns();
    emulator().time().wait_until(wanted + longer);
    if (longer > 0) emulator().overslept();
    return 0;
  }
  if (syscall(SYS_clock_nanosleep, clock, flags, until, left) != 0) return errno;
  const std::int64_t longer = emulator().oversleep_ns();
  if (longer > 0) {
    emulator().time().pass(longer);
    emulator().overslept();
  }
  return 0;
}

// Waiting for another process takes emulated time only if it does not answer: as long as it was
// waited for. It has as much of the machine's time for its answer.
int ppoll(pollfd* sockets, nfds_t count, const timespec* timeout, const sigset_t* signals) {
  timespec left = timeout != nullptr ? *timeout : timespec{};
  constexpr std::size_t kSignalBytes = 8;  // of the kernel's sigset_t
  const long ready = syscall(SYS_ppoll, sockets, count, timeout != nullptr ? &left : nullptr,
                             signals, kSignalBytes);
  auto& time = eagerx::emulated::emulator().time();
  if (ready == 0 && timeout != nullptr && time.emulated())
    time.pass(static_cast<std::int64_t>(timeout->tv_sec) * eagerx::emulated::kNsPerSecond +
              timeout->tv_nsec);
  return static_cast<int>(ready);
}

// With emulated time no thread waits for another: neither priority nor locked memory is requested
// from
// system, and both are said to be granted.
int sched_setscheduler(pid_t process, int policy, const sched_param* parameters) {
  if (eagerx::emulated::emulator().time().emulated()) return 0;
  return static_cast<int>(syscall(SYS_sched_setscheduler, process, policy, parameters));
}
int mlockall(int flags) {
  if (eagerx::emulated::emulator().time().emulated()) return 0;
  return static_cast<int>(syscall(SYS_mlockall, flags));
}

}  // extern "C"

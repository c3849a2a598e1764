#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>
#include <runtime/host/base/supervisor.hpp>

namespace eagerx::host {
namespace {

/// In memory that both processes have.
struct Signs {
  std::atomic<std::uint64_t> count = 0;
  std::atomic<std::int64_t> asleep_until_ns = 0;
  std::atomic<std::uint64_t> episode = 0, steps = 0;
  std::atomic<int> rests = 0;  // reasons for it
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

Signs* signs = nullptr;  // of the running supervisor

constexpr std::int64_t kMillisecondNs = 1'000'000;
constexpr std::int64_t kSecondNs = 1'000'000'000;

/// CLOCK_MONOTONIC, also where an emulator has one of its own.
std::int64_t now_ns() {
  timespec now{};
  syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * kSecondNs + now.tv_nsec;
}

enum class Outcome : std::uint8_t { dismissed, ended, hangs };

/// The meaning of a received byte, or that the pipe is closed.
Outcome read_line(int line) {
  char byte = 0;
  ssize_t count = 0;
  do count = read(line, &byte, 1);
  while (count < 0 && errno == EINTR);
  return count == 1 ? Outcome::dismissed : Outcome::ended;
}

/// Looks are counted, not time: where the whole machine stood still, the program had no chance.
Outcome watch(int line, std::int64_t most_silent_ns) {
  constexpr int kLooks = 16;
  constexpr std::int64_t kLongestMs = 1'000'000;
  const int look_ms =
      most_silent_ns <= 0
          ? -1
          : static_cast<int>(std::clamp<std::int64_t>(
                (most_silent_ns / kLooks + kMillisecondNs - 1) / kMillisecondNs, 1, kLongestMs));
  std::uint64_t last = 0;
  for (int looks = 0; looks < kLooks;) {
    pollfd item{line, POLLIN, 0};
    const int ready = poll(&item, 1, look_ms);
    if (ready > 0) return read_line(line);
    if (ready < 0) continue;
    const std::uint64_t count = signs->count;
    const bool is_alive =
        count == 0 || count != last || signs->rests > 0 || now_ns() < signs->asleep_until_ns;
    looks = is_alive ? 0 : looks + 1;
    last = count;
  }
  return Outcome::hangs;
}

/// Files that the program had open are free once it is no longer our parent.
void wait_for_its_end(pid_t program) {
  constexpr int kMostLooks = 2'000;
  constexpr useconds_t kLookUs = 1'000;
  for (int look = 0; look < kMostLooks && getppid() == program; ++look) usleep(kLookUs);
}

void tell(bool is_safe, std::int64_t most_silent_ns) {
  constexpr std::size_t kLongest = 640;
  std::array<char, kLongest> text{};
  const int size = std::snprintf(
      text.data(), text.size(),
      "error: the program sent no heartbeat for %g s, as it was stopped or hangs, and was "
      "killed: %s\n"
      "note: that was after step %" PRIu64 ", in episode %" PRIu64
      ", counted from 1; files are right up to a "
      "second before\n"
      "help: `heartbeat_timeout:` of the graph's `safety:` says how long that may be. Ctrl-Z stops "
      "a program "
      "safely, which SIGSTOP and debuggers do not\n",
      static_cast<double>(most_silent_ns) / static_cast<double>(kSecondNs),
      is_safe ? "its hardware has the safe values now"
              : "its hardware could NOT be made safe, as it does not answer",
      signs->steps.load(), signs->episode.load());
  // A child that does not read it is no supervisor.
  if (size > 0 && write(STDERR_FILENO, text.data(), static_cast<std::size_t>(size)) < 0) return;
}

[[noreturn]] void keep(int line, pid_t program, Supervisor::TakeOver take_over, void* context,
                       std::int64_t most_silent_ns) {
  setsid();
  // Those that the program ends well after, and tells us.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGPIPE})
    static_cast<void>(std::signal(signal, SIG_IGN));
  // If it may: a program with real-time priority that hangs leaves others no time. Not by the
  // function of the library, which an emulator may have replaced.
  sched_param first{};
  first.sched_priority = sched_get_priority_max(SCHED_FIFO);
  syscall(SYS_sched_setscheduler, 0, SCHED_FIFO, &first);
  const Outcome seen = watch(line, most_silent_ns);
  if (seen != Outcome::dismissed) {
    // A program that is stopped has its hardware for itself as long as it lives.
    if (seen == Outcome::hangs) kill(program, SIGKILL);
    wait_for_its_end(program);
    const bool is_safe = take_over(context);
    if (seen == Outcome::hangs) tell(is_safe, most_silent_ns);
  }
  _exit(0);
}

}  // namespace

Supervisor::Supervisor(TakeOver take_over, void* context, std::int64_t most_silent_ns) {
  if (take_over == nullptr) return;
  std::array<int, 2> ends{};
  const pid_t program = getpid();
  void* const memory =
      mmap(nullptr, sizeof(Signs), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory != MAP_FAILED) signs = ::new (memory) Signs;
  const bool has_line = memory != MAP_FAILED && pipe2(ends.data(), O_CLOEXEC) == 0;
  if (has_line) process_ = fork();
  if (process_ == 0) {
    close(ends[1]);
    keep(ends[0], program, take_over, context, most_silent_ns);
  }
  if (process_ < 0) {
    static_cast<void>(std::fprintf(
        stderr,
        "warning: no supervisor makes the hardware safe if this program is killed or stopped: %s\n",
        std::strerror(errno)));
  }
  if (has_line) close(ends[0]);
  if (has_line && process_ < 0) close(ends[1]);
  if (process_ > 0) line_ = ends[1];
}

Supervisor::~Supervisor() {
  if (process_ > 0) {
    const char byte = 1;
    ssize_t written = 0;
    do written = write(line_, &byte, 1);
    while (written < 0 && errno == EINTR);
    close(line_);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (signs != nullptr) munmap(signs, sizeof *signs);
  signs = nullptr;
}

namespace {

/// Only this process writes: no need to lock the bus.
void add_one() {
  signs->count.store(signs->count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

}  // namespace

void send_heartbeat() {
  if (signs != nullptr && signs->count.load(std::memory_order_relaxed) != 0) add_one();
}

void send_heartbeat(std::uint64_t episode, std::uint64_t steps) {
  if (signs == nullptr) return;
  signs->episode.store(episode, std::memory_order_relaxed);
  signs->steps.store(steps, std::memory_order_relaxed);
  add_one();
}

void say_asleep_until(std::int64_t ns) {
  if (signs == nullptr) return;
  signs->asleep_until_ns.store(ns, std::memory_order_relaxed);
  send_heartbeat();
}

WatchdogPause::WatchdogPause() {
  if (signs != nullptr) ++signs->rests;
}
WatchdogPause::~WatchdogPause() {
  if (signs != nullptr) --signs->rests;
  send_heartbeat();
}

}  // namespace eagerx::host

void eagerx_sleeps_until(std::int64_t ns) {
  eagerx::host::say_asleep_until(ns);
}

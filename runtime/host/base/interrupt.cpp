#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/supervisor.hpp>

namespace eagerx::host {

Interrupt caught = false;

namespace {

// Ends a run. With all real-time signals these are what would end the program by default.
constexpr std::array kEnds{SIGHUP,    SIGINT,  SIGTERM, SIGQUIT, SIGUSR1, SIGUSR2,  SIGALRM,
                           SIGVTALRM, SIGPROF, SIGXCPU, SIGPOLL, SIGPWR,  SIGSTKFLT};
// A crash, or a signal that looks like one.
constexpr std::array kCrashes{SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGSYS, SIGTRAP};
constexpr std::array kStops{SIGTSTP, SIGTTIN, SIGTTOU};

// Signal handlers and threads read and write these; all are lock-free.
std::atomic<int> ending_signal = 0;             // the signal that end_by_signal() ends with
std::atomic<int> stop_signal = 0;               // that wants the program to stop
std::atomic<std::int64_t> first_ctrl_c_ms = 0;  // 0: there was none
std::atomic<bool> dying = false;
std::atomic<void (*)(void*)> make_safe = nullptr;
std::atomic<void*> made_safe = nullptr;
bool (*gone)(void*) = nullptr;  // of the main thread
void* gone_context = nullptr;

}  // namespace

void make_safe_now() {
  if (auto* const f = make_safe.load()) f(made_safe.load());
}

namespace {

void set_default(int signal) {
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  sigaction(signal, &usual, nullptr);
}

void unblock(int signal) {
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, signal);
  pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
}

/// Makes safe from within a signal handler, then ends by `signal`. What was going on may have left
/// a bus or a lock in any state: after a second the program ends without it.
void end_at_once(int signal) {
  set_default(signal);
  if (!dying.exchange(true)) {
    set_default(SIGALRM);
    unblock(SIGALRM);
    alarm(1);
    make_safe_now();
  }
  raise(signal);
  unblock(signal);
}

/// Above 0. Of a clock that no emulator replaces: its clock is not for signal handlers.
std::int64_t now_ms() {
  constexpr std::int64_t kMsPerSecond = 1'000;
  constexpr std::int64_t kNsPerMs = 1'000'000;
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return std::int64_t{now.tv_sec} * kMsPerSecond + now.tv_nsec / kNsPerMs + 1;
}

void on_end(int signal) {
  const int before = errno;
  caught = true;
  if (signal == SIGQUIT) ending_signal = signal;
  if (signal == SIGINT) {
    // Two that come together are one Ctrl-C of somebody in a hurry: the first one is at work.
    constexpr std::int64_t kPatienceMs = 1'000;
    std::int64_t first = 0;
    const std::int64_t now = now_ms();
    if (!first_ctrl_c_ms.compare_exchange_strong(first, now) && now - first >= kPatienceMs)
      end_at_once(signal);
  }
  errno = before;
}

void on_crash(int signal, siginfo_t* info, void* /*context*/) {
  const int before = errno;
  const bool is_sent = info->si_code <= 0 && info->si_pid != getpid();
  if (is_sent && ending_signal.exchange(signal) != signal) {
    caught = true;  // nothing has happened to the program: it ends in good order
  } else {
    end_at_once(signal);
  }
  errno = before;
}

void on_stop_signal(int signal) {
  stop_signal = signal;
}

bool is_ignored(int signal) {
  struct sigaction before {};
  return sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN;
}

/// Without SA_RESTART: a sleep ends early.
void catch_end(int signal) {
  // `nohup` has SIGHUP ignored; a shell has what Ctrl-C sends ignored for programs in the
  // background, and somebody who sends that to one of them means it.
  if (signal != SIGINT && signal != SIGTERM && is_ignored(signal)) return;
  struct sigaction action {};
  action.sa_handler = on_end;
  sigaction(signal, &action, nullptr);
}

void catch_stop(int signal) {
  if (is_ignored(signal)) return;
  struct sigaction action {};
  action.sa_handler = on_stop_signal;
  sigaction(signal, &action, nullptr);
}

/// On a stack of its own, for a crash may be the end of the usual one. All other signals wait.
void catch_crashes() {
  constexpr std::size_t kStackBytes = std::size_t{1} << 17U;  // libusb and a driver's batch
  static std::array<char, kStackBytes> stack;
  stack_t other{};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_sigaction = on_crash;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigfillset(&action.sa_mask);
  for (const int signal : kCrashes) sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
  for (const int signal : kEnds) catch_end(signal);
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) catch_end(signal);
  for (const int signal : kStops) catch_stop(signal);
  catch_crashes();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

const Interrupt& watch_interrupts(std::initializer_list<int> signals, Second second) {
  struct sigaction action {};
  action.sa_handler = [](int) { caught = true; };
  if (second == Second::ends) action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (const int signal : signals) sigaction(signal, &action, nullptr);
  return caught;
}

void on_stop(void (*f)(void*), void* context) {
  make_safe = nullptr;
  made_safe = context;
  make_safe = f;
}

void on_gone(bool (*f)(void*), void* context) {
  gone = f;
  gone_context = context;
}

bool ends_reset() {
  send_heartbeat();
  return interrupted() || is_stop_requested() || (gone != nullptr && gone(gone_context));
}

bool is_stop_requested() {
  return stop_signal.load(std::memory_order_relaxed) != 0;
}

void stop_if_requested() {
  send_heartbeat();
  for (int signal = stop_signal.exchange(0); signal != 0; signal = stop_signal.exchange(0)) {
    make_safe_now();
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    set_default(signal);
    {
      const WatchdogPause safely;
      raise(signal);  // here it stands still
    }
    sigaction(signal, &before, nullptr);
  }
}

void end_by_signal() {
  const int signal = ending_signal.load();
  if (signal == 0) return;
  set_default(signal);
  raise(signal);
}

}  // namespace eagerx::host

bool eagerx_is_interrupted() {
  return eagerx::host::ends_reset();
}

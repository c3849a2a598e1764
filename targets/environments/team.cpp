#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <targets/environments/team.hpp>

namespace eagerx::environments {
namespace {

constexpr int kSpins = 2000;  // some microseconds

/// Signals are for the program's own threads.
class NoSignals {
 public:
  NoSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

}  // namespace

unsigned usable_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof(cores), &cores) == 0)
    return std::max(1U, static_cast<unsigned>(CPU_COUNT(&cores)));
  return std::max(1U, std::thread::hardware_concurrency());
}

Team::Team(unsigned size) : process_(getpid()) {
  const NoSignals inherited;
  threads_.reserve(size - 1);
  try {
    for (unsigned i = 1; i < size; ++i) threads_.emplace_back([this, i] { work(i); });
  } catch (...) {
    stop();
    throw;
  }
}

Team::~Team() {
  stop();
}

bool Team::is_complete() const {
  return threads_.empty() || getpid() == process_;
}

void Team::begin(unsigned members) {
  at_work_.store(members - 1, std::memory_order_relaxed);
  const std::uint64_t number = (turn_.load(std::memory_order_relaxed) >> kMemberBits) + 1;
  turn_.store((number << kMemberBits) | members, std::memory_order_release);
  turn_.notify_all();
}

void Team::wait() const {
  for (int spin = 0; at_work_.load(std::memory_order_acquire) != 0; ++spin) {
    if (spin > kSpins) std::this_thread::yield();
  }
}

void Team::work(unsigned i) {
  constexpr std::uint64_t kMembers = (std::uint64_t{1} << kMemberBits) - 1;
  std::uint64_t seen = 0;
  for (;;) {
    for (int spin = 0; spin < kSpins && turn_.load(std::memory_order_relaxed) == seen; ++spin) {
    }
    turn_.wait(seen, std::memory_order_relaxed);
    // Whoever takes part sees its turn, because run() waits for it; others may miss some.
    seen = turn_.load(std::memory_order_acquire);
    if ((seen & kMembers) == 0) return;
    if (i >= (seen & kMembers)) continue;
    call_(job_, i);
    at_work_.fetch_sub(1, std::memory_order_release);
  }
}

void Team::stop() {
  const bool complete = is_complete();
  turn_.store(((turn_.load() >> kMemberBits) + 1) << kMemberBits);
  turn_.notify_all();
  for (std::thread& thread : threads_) complete ? thread.join() : thread.detach();
  threads_.clear();
}

}  // namespace eagerx::environments

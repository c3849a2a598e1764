#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <runtime/host/base/background.hpp>
#include <runtime/host/base/thread_pool.hpp>
#include <system_error>
#include <utility>

namespace eagerx::host {
namespace {

constexpr int kSpins = 2000;   // some microseconds
constexpr int kYields = 1000;  // some hundred more: waking up costs a caller of short jobs as much

// Of ThreadPool::door_: as many bits for threads as a turn has for members.
constexpr std::uint64_t kReturned = 1;
constexpr std::uint64_t kCome = std::uint64_t{1} << 16U;
constexpr std::uint64_t kClosed = std::uint64_t{1} << 32U;
constexpr unsigned kNumberShift = 33;

/// The door of a turn that no thread has joined.
std::uint64_t door_of(std::uint64_t number) {
  return number << kNumberShift;
}
unsigned returned(std::uint64_t door) {
  return static_cast<unsigned>(door % kCome);
}
unsigned come(std::uint64_t door) {
  return static_cast<unsigned>(door / kCome % kCome);
}

}  // namespace

unsigned usable_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof(cores), &cores) == 0)
    return std::max(1U, static_cast<unsigned>(CPU_COUNT(&cores)));
  return std::max(1U, std::thread::hardware_concurrency());
}

ThreadPool::ThreadPool(unsigned size, Size kind) : process_(getpid()) {
  const NoSignals inherited;
  threads_.reserve(size - 1);
  try {
    for (unsigned i = 1; i < size; ++i) threads_.emplace_back([this, i] { work(i); });
  } catch (const std::system_error&) {
    if (kind == Size::at_most) return;
    stop();
    throw;
  } catch (...) {  // a thread without a join would end the program
    stop();
    throw;
  }
}

ThreadPool::~ThreadPool() {
  stop();
}

bool ThreadPool::is_in_its_process() const {
  return getpid() == process_;
}

void ThreadPool::run_parts(std::size_t parts, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;  // of what stands below
  std::exception_ptr failure;
  std::size_t failed = 0;
  const auto members = static_cast<unsigned>(std::clamp<std::size_t>(parts, 1, size()));
  share(members, [&](unsigned) {
    for (std::size_t part = next++; part < parts; part = next++) {
      try {
        work(part);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure || part < failed) {
          failure = std::current_exception();
          failed = part;
        }
      }
    }
  });
  if (failure) std::rethrow_exception(failure);
}

void ThreadPool::begin(unsigned members) {
  const std::uint64_t number = (turn_.load(std::memory_order_relaxed) >> kMemberBits) + 1;
  door_.store(door_of(number), std::memory_order_release);
  turn_.store((number << kMemberBits) | members, std::memory_order_release);
  turn_.notify_all();
}

void ThreadPool::call(unsigned i) noexcept {
  try {
    call_(job_, i);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
}

/// Whether a thread that has seen `turn` may take part in it. What the caller wrote before it began
/// is seen then.
bool ThreadPool::enter(std::uint64_t turn) {
  std::uint64_t door = door_.load(std::memory_order_acquire);
  do {
    const bool is_over = door >> kNumberShift != door_of(turn >> kMemberBits) >> kNumberShift;
    if (is_over || (door & kClosed) != 0) return false;
  } while (!door_.compare_exchange_weak(door, door + kCome, std::memory_order_acq_rel,
                                        std::memory_order_acquire));
  return true;
}

/// Closes the turn to further threads; returns how many have come.
unsigned ThreadPool::close() {
  return come(door_.fetch_or(kClosed, std::memory_order_acq_rel));
}

void ThreadPool::wait_for(unsigned finished) const {
  int spin = 0;
  for (std::uint64_t door = 0; returned(door = door_.load(std::memory_order_acquire)) != finished;
       ++spin) {
    if (spin > kSpins + kYields)
      door_.wait(door, std::memory_order_acquire);
    else if (spin > kSpins)
      std::this_thread::yield();
  }
}

void ThreadPool::end() {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::work(unsigned i) {
  constexpr std::uint64_t kMembers = (std::uint64_t{1} << kMemberBits) - 1;
  std::uint64_t seen = 0;
  for (;;) {
    for (int spin = 0; spin < kSpins && turn_.load(std::memory_order_relaxed) == seen; ++spin) {
    }
    turn_.wait(seen, std::memory_order_relaxed);
    // A thread that takes part in a run() sees its turn, because run() waits for all; others may
    // miss some.
    seen = turn_.load(std::memory_order_acquire);
    if ((seen & kMembers) == 0) return;
    if (i >= (seen & kMembers) || !enter(seen)) continue;
    call(i);
    door_.fetch_add(kReturned, std::memory_order_release);
    door_.notify_one();
  }
}

void ThreadPool::stop() {
  const bool complete = is_complete();
  turn_.store(((turn_.load() >> kMemberBits) + 1) << kMemberBits);
  turn_.notify_all();
  for (std::thread& thread : threads_) complete ? thread.join() : thread.detach();
  threads_.clear();
}

}  // namespace eagerx::host

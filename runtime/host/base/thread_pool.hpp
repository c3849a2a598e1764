// A pool of threads that run one job together, repeatedly.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace eagerx::host {

/// Cores that this process may use, at least 1.
unsigned usable_cores();

/// The caller is thread 0. Threads that have nothing to do spin for some microseconds, then sleep,
/// and get no signals.
class ThreadPool {
 public:
  enum class Size : std::uint8_t { exact, at_most };

  /// `size` members from 1 to 65535. If the system has no more threads: throws std::system_error,
  /// or takes as many as there are.
  explicit ThreadPool(unsigned size, Size kind = Size::exact);
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool();

  unsigned size() const { return static_cast<unsigned>(threads_.size()) + 1; }
  /// False in a process that fork() made, where only the caller lives.
  bool is_complete() const { return threads_.empty() || is_in_its_process(); }

  /// Calls job(i) for each i < `members` in parallel; returns when all have returned, and rethrows
  /// an exception of one of them. 1 <= members <= size().
  template <class Job>
  void run(unsigned members, Job&& job) {
    if (members == 1) return job(0U);
    auto one = [&job](unsigned i) { job(i); };
    begin(members, one);
    call(0);
    wait_for(members - 1);
    end();
  }
  /// Calls job(0), and job(i) for those i < `members` whose threads start before job(0) has
  /// returned: on a busy machine, a core may become free only when no work is left. So each job
  /// must take work until none is left. Returns when all started jobs have returned; throws like
  /// run().
  template <class Job>
  void share(unsigned members, Job&& job) {
    if (members == 1) return job(0U);
    auto one = [&job](unsigned i) { job(i); };
    begin(members, one);
    call(0);
    wait_for(close());
    end();
  }

  /// work(part) for 0 … parts - 1, each once, by whichever member is free; returns when all have
  /// returned. Throws the exception of the first part that has thrown one; the others are done.
  void run_parts(std::size_t parts, const std::function<void(std::size_t)>& work);

 private:
  bool is_in_its_process() const;
  template <class Job>
  void begin(unsigned members, Job& job) {
    call_ = [](void* what, unsigned i) { (*static_cast<Job*>(what))(i); };
    job_ = &job;  // call_ knows what it is
    begin(members);
  }
  void begin(unsigned members);
  bool enter(std::uint64_t turn);
  void call(unsigned i) noexcept;
  unsigned close();
  void wait_for(unsigned finished) const;
  void end();
  void work(unsigned i);
  void stop();

  // A turn's number above, how many take part below.
  static constexpr unsigned kMemberBits = 16;
  std::atomic<std::uint64_t> turn_{0};
  // Of the turn with this number, from above: the number, whether it is closed, how
  // many threads have come, how many of them have returned.
  std::atomic<std::uint64_t> door_{0};
  void (*call_)(void*, unsigned) = nullptr;
  void* job_ = nullptr;
  std::mutex mutex_;
  std::exception_ptr failure_;  // what a job has thrown; written under the mutex
  pid_t process_;
  std::vector<std::thread> threads_;
};

}  // namespace eagerx::host

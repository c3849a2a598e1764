// Threads that do one thing together, again and again.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <thread>
#include <type_traits>
#include <vector>

namespace eagerx::environments {

/// Cores that this process may use, at least 1.
unsigned usable_cores();

/// The caller is member 0. Members that have nothing to do spin for some microseconds, then sleep.
class Team {
 public:
  /// Throws std::system_error if the system has no more threads.
  explicit Team(unsigned size);
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team();

  unsigned size() const { return static_cast<unsigned>(threads_.size()) + 1; }
  /// False in a process that fork() made, where only the caller lives.
  bool is_complete() const;

  /// job(i) for each i < `members`, at once; returns when all have returned. 1 <= members <=
  /// size().
  template <class Job>
  void run(unsigned members, Job&& job) {
    if (members == 1) return job(0U);
    call_ = [](void* what, unsigned i) { (*static_cast<std::remove_reference_t<Job>*>(what))(i); };
    job_ = &job;
    begin(members);
    job(0U);
    wait();
  }

 private:
  void begin(unsigned members);
  void wait() const;
  void work(unsigned i);
  void stop();

  // A turn's number above, how many take part below.
  static constexpr unsigned kMemberBits = 16;
  std::atomic<std::uint64_t> turn_{0};
  std::atomic<unsigned> at_work_{0};
  void (*call_)(void*, unsigned) = nullptr;
  void* job_ = nullptr;
  pid_t process_;
  std::vector<std::thread> threads_;
};

}  // namespace eagerx::environments

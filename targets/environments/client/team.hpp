// Threads that work on parts of one task together.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace eagerx::client {

class Team {
 public:
  /// The caller is one of `threads`; fewer, if the system has no more.
  explicit Team(unsigned threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Calls work(part) for 0 … parts - 1, each once, on whichever thread is free; returns when all
  /// have returned. Throws the exception of the first part that has thrown one.
  void run(std::size_t parts, const std::function<void(std::size_t)>& work);

 private:
  void take_parts();
  void serve();

  std::vector<std::thread> helpers_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t parts_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::uint32_t> task_ = 0;  // counts tasks
  std::atomic<std::uint32_t> busy_ = 0;  // helpers that have not finished the task
  std::atomic<bool> leave_ = false;
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::size_t failed_ = 0;  // the part of it
};

}  // namespace eagerx::client

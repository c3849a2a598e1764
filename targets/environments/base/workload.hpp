// Number of threads that a step of many environments is worth.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <runtime/host/base/thread_pool.hpp>

namespace eagerx::environments {

/// Environments that a thread takes at a time, whole SIMD groups of `lanes`: few, so that none
/// waits for another's block.
constexpr std::uint32_t block_of(std::uint32_t environments, std::uint32_t lanes) {
  constexpr std::uint32_t kBlocks = 64;
  constexpr std::uint32_t kLargest = 128;
  const std::uint32_t wanted = std::clamp(environments / kBlocks, 1U, kLargest);
  lanes = std::max(1U, lanes);
  return (wanted + lanes - 1) / lanes * lanes;
}

/// The work on the environments `first` to `end` - 1 by a thread of a pool: a reference to a
/// function, so that its text is compiled once, however it is called.
class BlockWork {
 public:
  template <class F>
  explicit BlockWork(F& f)
      : what_(std::addressof(f)),
        call_([](void* what, std::uint32_t first, std::uint32_t end, unsigned member) {
          (*static_cast<F*>(what))(first, end, member);
        }) {}
  void operator()(std::uint32_t first, std::uint32_t end, unsigned member) const {
    call_(what_, first, end, member);
  }

 private:
  void* what_;
  void (*call_)(void* what, std::uint32_t first, std::uint32_t end, unsigned member);
};

/// How many threads of a pool are worth waking, estimated from the time of the last steps.
class Workload {
 public:
  unsigned members(unsigned most) const;
  /// For blocks of `environments`, by as many threads of the pool as the work is worth.
  void run(host::ThreadPool& pool, std::uint32_t environments, std::uint32_t block, BlockWork work);

 private:
  void note(unsigned members, double elapsed_ns);

  double work_ns_ = 0.0;  // of all members
};

}  // namespace eagerx::environments

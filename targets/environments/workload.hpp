// How many threads a step of many environments is worth.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <runtime/host/base/team.hpp>

namespace eagerx::environments {

/// Environments that a thread takes at a time, whole packs of `lanes`: few, so that none waits for
/// another's block.
constexpr std::uint32_t block_of(std::uint32_t environments, std::uint32_t lanes) {
  constexpr std::uint32_t kBlocks = 64;
  constexpr std::uint32_t kLargest = 128;
  const std::uint32_t wanted = std::clamp(environments / kBlocks, 1U, kLargest);
  lanes = std::max(1U, lanes);
  return (wanted + lanes - 1) / lanes * lanes;
}

/// How many members of a team are worth their waking, from what the last steps took.
class Workload {
 public:
  unsigned members(unsigned most) const {
    constexpr double kLeastOfMember_ns = 50'000.0;
    const double wanted = work_ns_ / kLeastOfMember_ns;
    return wanted >= most ? most : std::max(1U, static_cast<unsigned>(wanted));
  }
  /// f(first, end, member) for blocks of `environments`, by as many members of the team as the work
  /// is worth.
  template <class F>
  void run(host::Team& team, std::uint32_t environments, std::uint32_t block, F&& f) {
    using Clock = std::chrono::steady_clock;
    const unsigned members = this->members(team.size());
    const auto start = Clock::now();
    std::atomic<std::uint32_t> next{0};
    if (members == 1) block = environments;
    team.share(members, [&](unsigned member) {
      for (;;) {
        const std::uint32_t first = next.fetch_add(block, std::memory_order_relaxed);
        if (first >= environments) return;
        f(first, std::min(environments, first + block), member);
      }
    });
    const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
    note(members, elapsed.count());
  }

 private:
  void note(unsigned members, double elapsed_ns) {
    constexpr double kNew = 0.125;
    const double work_ns = elapsed_ns * members;
    work_ns_ = work_ns_ == 0.0 ? work_ns : work_ns_ + kNew * (work_ns - work_ns_);
  }

  double work_ns_ = 0.0;  // of all members
};

}  // namespace eagerx::environments

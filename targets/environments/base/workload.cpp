#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <runtime/host/base/thread_pool.hpp>
#include <targets/environments/base/workload.hpp>

namespace eagerx::environments {

unsigned Workload::members(unsigned most) const {
  constexpr double kLeastOfMember_ns = 50'000.0;
  const double wanted = work_ns_ / kLeastOfMember_ns;
  return wanted >= most ? most : std::max(1U, static_cast<unsigned>(wanted));
}

void Workload::run(host::ThreadPool& pool, std::uint32_t environments, std::uint32_t block,
                   BlockWork work) {
  using Clock = std::chrono::steady_clock;
  const unsigned members = this->members(pool.size());
  const auto start = Clock::now();
  std::atomic<std::uint32_t> next{0};
  if (members == 1) block = environments;
  pool.share(members, [&](unsigned member) {
    for (;;) {
      const std::uint32_t first = next.fetch_add(block, std::memory_order_relaxed);
      if (first >= environments) return;
      work(first, std::min(environments, first + block), member);
    }
  });
  const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
  note(members, elapsed.count());
}

void Workload::note(unsigned members, double elapsed_ns) {
  constexpr double kNew = 0.125;
  const double work_ns = elapsed_ns * members;
  work_ns_ = work_ns_ == 0.0 ? work_ns : work_ns_ + kNew * (work_ns - work_ns_);
}

}  // namespace eagerx::environments

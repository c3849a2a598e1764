// How many threads a step of many environments is worth.
#pragma once

#include <algorithm>

namespace eagerx::environments {

/// How many members of a team are worth their waking, from what the last steps took.
class Workload {
 public:
  unsigned members(unsigned most) const {
    constexpr double kLeastOfMember_ns = 50'000.0;
    const double wanted = work_ns_ / kLeastOfMember_ns;
    return wanted >= most ? most : std::max(1U, static_cast<unsigned>(wanted));
  }
  void note(unsigned members, double elapsed_ns) {
    constexpr double kNew = 0.125;
    const double work_ns = elapsed_ns * members;
    work_ns_ = work_ns_ == 0.0 ? work_ns : work_ns_ + kNew * (work_ns - work_ns_);
  }

 private:
  double work_ns_ = 0.0;  // of all members
};

}  // namespace eagerx::environments

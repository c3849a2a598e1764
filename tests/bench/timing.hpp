// Time of two things that are run in turn, so that what else the machine does hits both alike.
#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace eagerx::bench {

/// Processor time of this thread in ns: waiting for other programs does not count.
inline double now_ns() {
  constexpr double kNsInS = 1e9;
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * kNsInS + static_cast<double>(now.tv_nsec);
}

struct Best {
  double first_ns = std::numeric_limits<double>::infinity();
  double second_ns = std::numeric_limits<double>::infinity();
};

/// The shortest of `repeats` runs of each; one run of each before is not counted.
template <class First, class Second>
Best time_in_turn(int repeats, First&& first, Second&& second) {
  Best best;
  for (int i = -1; i < repeats; ++i) {
    const double start = now_ns();
    first();
    const double middle = now_ns();
    second();
    const double end = now_ns();
    if (i < 0) continue;
    best.first_ns = std::min(best.first_ns, middle - start);
    best.second_ns = std::min(best.second_ns, end - middle);
  }
  return best;
}

}  // namespace eagerx::bench

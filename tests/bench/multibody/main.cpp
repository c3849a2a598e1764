// Robots that stand on their servos, in steps of 5 ms: substeps a second of processor time.
// Arguments: `time`, or a number of substeps to make, for those who count instructions.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#if defined(WITH_OPEN_DYNAMICS_ENGINE)
#include "tests/bench/multibody/open_dynamics_robot.hpp"
#elif defined(MUJOCO_CONE)
#include "tests/bench/multibody/mujoco_robot.hpp"
#else
#include "tests/bench/multibody/multibody_robots.hpp"
#endif

namespace {

constexpr double kStanding = 0.2;  // height [m]

double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  bench::Robots robots;
  if (argc == 2 && std::strcmp(argv[1], "time") != 0) {
    for (long n = std::atol(argv[1]); n > 0; --n) robots.step();
    return robots.height() > kStanding ? 0 : 1;
  }
  for (int i = 0; i < 200; ++i) robots.step();
  double best = 0.0;
  for (int i = 0; i < 10; ++i) {
    long steps = 0;
    const double start = processor_time();
    double now = start;
    for (; now - start < 0.1; now = processor_time(), steps += 8) {
      for (int k = 0; k < 8; ++k) robots.step();
    }
    const double rate = static_cast<double>(steps) * bench::kRobots / (now - start);
    if (rate > best) best = rate;
  }
  std::printf("%.4f %.4f\n", best / 1e6, robots.height());
  return robots.height() > kStanding ? 0 : 1;
}

// A walker of twelve joints that stands on its servos: substeps a second of processor time.
// Arguments: `time`, or a number of substeps to make, for those who count instructions.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <eagerx/simd.hpp>
#include <vector>

#include "tests/unit/multibody/robots.hpp"

#if defined(WITH_OPEN_DYNAMICS_ENGINE)
#include "tests/unit/rigid/rigid_io.hpp"
#endif

namespace {

using namespace eagerx::models;
using namespace eagerx::models::testing;

constexpr double kStep = 0.005;  // [s]
constexpr double kHome[3] = {0.0, 0.9, -1.8};

double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

#if defined(WITH_OPEN_DYNAMICS_ENGINE)
constexpr std::size_t kRobots = 1;
struct Config : RigidConfig<1> {
  static constexpr auto method = OpenDynamicsMethod::quick_step;
};
struct Robots {
  using Io = EngineIo<double, Config, eagerx::Rate<200>>;
  OpenDynamicsSimulator<WalkerOf<double>> simulator{};
  OpenDynamicsEngine<Io> engine{};

  Robots() {
    eagerx::start(engine, simulator);
    simulator.want_pose(0, {{0.0, 0.0, 0.28, 1.0, 0.0, 0.0, 0.0}});
    for (std::size_t j = 0; j < 12; ++j) {
      simulator.want_joint(j, {{kHome[j % 3], 0.0}, {0.0, 0.0}});
      simulator.set_joint_servo(j, {kHome[j % 3], 40.0, 1.0, 33.5});
    }
    eagerx::reset_engine(engine, NoStates{}, simulator);
  }
  void step() { engine.callback({1}, simulator); }
  double height() { return simulator.pose(0)[2]; }
};
#else
constexpr std::size_t kRobots = 64;
#if LANES == 1
using Real = float;
#else
using Real = eagerx::Simd<float, LANES>;
#endif
using One = MultibodySimulator<WalkerOf<float>>;
using Simd = MultibodySimulator<WalkerOf<Real>>;

/// In a function of its own, so that instructions are those of a step.
[[gnu::noinline]] void step_group(Simd& simd) {
  constexpr multibody::ContactSettings<float> kSettings{2e4F, 400.0F, 0.005F, 0.2F,
                                                        static_cast<float>(kStep)};
  simd.step(kSettings, 4);
}

struct Robots {
  std::vector<Simd> simds = std::vector<Simd>(kRobots / LANES);

  Robots() {
    for (std::size_t e = 0; e < kRobots; ++e) {
      One one{};
      one.start({{0.0, 0.0, -9.81}});
      one.want_pose(0,
                    {{0.0, 0.0, 0.28 + 0.001 * static_cast<double>(e % 50), 1.0, 0.0, 0.0, 0.0}});
      for (std::size_t j = 0; j < 12; ++j) {
        const auto off = static_cast<float>((e * 5 + j) % 13) * 0.01F - 0.06F;
        one.want_joint(j, {{kHome[j % 3], 0.0}, {0.0, 0.0}});
        one.set_joint_servo(j, {static_cast<float>(kHome[j % 3]) + off, 40.0F, 1.0F, 33.5F});
      }
      one.begin_episode();
      static_assert(sizeof(Simd) == LANES * sizeof(One));
      auto* const to = reinterpret_cast<char*>(&simds[e / LANES]);
      for (std::size_t word = 0; word < sizeof(One) / 4; ++word)
        std::memcpy(to + 4 * (word * LANES + e % LANES), reinterpret_cast<char*>(&one) + 4 * word,
                    4);
    }
  }
  void step() {
    for (Simd& simd : simds) step_group(simd);
  }
  double height() {
    double sum = 0.0;
    for (std::size_t e = 0; e < kRobots; ++e)
      sum += static_cast<double>(
          eagerx::lane(simds[e / LANES].numbers().position.z, static_cast<int>(e % LANES)));
    return sum / kRobots;
  }
};
#endif

}  // namespace

int main(int argc, char** argv) {
  Robots robots;
  if (argc == 2 && std::strcmp(argv[1], "time") != 0) {
    for (long n = std::atol(argv[1]); n > 0; --n) robots.step();
    return robots.height() > 0.2 ? 0 : 1;
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
    const double rate = static_cast<double>(steps) * kRobots / (now - start);
    if (rate > best) best = rate;
  }
  std::printf("%.3f %.4f\n", best / 1e6, robots.height());
  return robots.height() > 0.2 ? 0 : 1;
}

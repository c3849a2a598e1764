// The walker on OpenDynamicsEngine, by QuickStep.
#pragma once

#include "tests/unit/multibody/robots.hpp"
#include "tests/unit/rigid/rigid_io.hpp"

namespace bench {

using namespace eagerx::models;
using namespace eagerx::models::testing;

constexpr std::size_t kRobots = 1;
constexpr double kHome[3] = {0.0, 0.9, -1.8};
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

}  // namespace bench

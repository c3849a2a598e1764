// The walker in MuJoCo, by its Newton solver, with the cones of friction that MUJOCO_CONE names.
#pragma once

#include <algorithm>

#include "tests/mujoco/plant.hpp"
#include "tests/unit/multibody/robots.hpp"

namespace bench {

using namespace eagerx::models::testing;

constexpr std::size_t kRobots = 1;
constexpr double kHome[3] = {0.0, 0.9, -1.8};

struct Robots {
  using Walker = WalkerOf<double>;
  eagerx::mujoco::Plant<Walker> plant{{.step_s = 0.005, .options = "cone='" MUJOCO_CONE "'"}};

  Robots() {
    plant.data->qpos[2] = 0.28;
    for (std::size_t j = 0; j < 12; ++j) {
      plant.data->qpos[plant.position_of(j)] = kHome[j % 3];
      // The servo's damping is the joint's, which MuJoCo has at the end of the step.
      plant.model->dof_damping[plant.velocity_of(j)] += 1.0;
      position_[j] = plant.position_of(j);
      velocity_[j] = plant.velocity_of(j);
    }
  }
  void step() {
    for (std::size_t j = 0; j < 12; ++j)
      plant.data->qfrc_applied[velocity_[j]] =
          std::clamp(40.0 * (kHome[j % 3] - plant.data->qpos[position_[j]]), -33.5, 33.5);
    mj_step(plant.model, plant.data);
  }
  double height() { return plant.data->qpos[2]; }

 private:
  int position_[12], velocity_[12];
};

}  // namespace bench

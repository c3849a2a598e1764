// Accelerations of a robot that eagerx-urdf made of a file in MJCF, against MuJoCo's with the file
// itself: compiled with -include of its header, whose class is Robot. `description FILE.xml`: at
// 1,000 random states of joints and base, without contacts, stops and dry friction, the largest
// difference of accelerations of joints, of the largest acceleration.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <models/engines/multibody_engine/multibody_simulator.hpp>
#include <vector>

#include "tests/unit/multibody/sampled_state.hpp"

namespace {

using namespace eagerx::models;
using namespace eagerx::models::testing;

struct Config {
  static constexpr std::array<double, 3> origin{};
  static constexpr bool touches_itself = false;
  static constexpr double friction = 1.0, bounce = 0.0;
};
struct Io {
  using Real = double;
  using Config = ::Config;
};
/// Without contacts, stops, limits and dry friction.
struct Model : Robot<Io> {
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
  static constexpr std::array<std::array<const char*, 2>, 0> kPairs = {};
  static constexpr auto kJoints = [] {
    auto joints = Robot<Io>::kJoints;
    for (RigidJoint& joint : joints) {
      joint.low = -std::numeric_limits<double>::infinity();
      joint.high = joint.max_torque = joint.max_velocity = -joint.low;
      joint.friction = 0.0;
    }
    return joints;
  }();
};
constexpr int kStates = 1000;

/// Accelerations of the joints, which have the same names in MuJoCo.
std::vector<double> of_mujoco(const mjModel& model, mjData& data, const SampledState<Model>& at) {
  mj_resetData(&model, &data);
  for (int j = 0; j < model.njnt; ++j) {
    if (model.jnt_type[j] != mjJNT_FREE) continue;
    double* const q = data.qpos + model.jnt_qposadr[j];
    std::copy_n(&at.pose[0], 7, q);
    mju_normalize4(q + 3);
    double back[4];
    mju_negQuat(back, q + 3);
    std::copy_n(&at.twist[0], 3, data.qvel + model.jnt_dofadr[j]);
    mju_rotVecQuat(data.qvel + model.jnt_dofadr[j] + 3, &at.twist[3], back);
  }
  std::vector<int> places;
  for (std::size_t j = 0; j < at.kJoints; ++j) {
    const int id = mj_name2id(&model, mjOBJ_JOINT, Model::kJoints[j].name);
    if (id < 0) {
      std::fprintf(stderr, "error: MuJoCo has no joint %s\n", Model::kJoints[j].name);
      std::exit(2);
    }
    data.qpos[model.jnt_qposadr[id]] = at.q[j];
    data.qvel[model.jnt_dofadr[id]] = at.v[j];
    data.qfrc_applied[model.jnt_dofadr[id]] = at.torque[j];
    places.push_back(model.jnt_dofadr[id]);
  }
  mj_forward(&model, &data);
  std::vector<double> result;
  for (const int place : places) result.push_back(data.qacc[place]);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  char error[1000] = "";
  mjModel* const model = argc == 2 ? mj_loadXML(argv[1], nullptr, error, sizeof error) : nullptr;
  if (model == nullptr) {
    std::fprintf(stderr, "error: MuJoCo refuses the file: %s\n", error);
    return 2;
  }
  model->opt.disableflags |= mjDSBL_CONTACT | mjDSBL_CONSTRAINT;
  model->opt.gravity[0] = model->opt.gravity[1] = 0.0;
  model->opt.gravity[2] = -9.81;
  mjData* const data = mj_makeData(model);
  Sampler sample;
  double worst = 0.0;
  for (int n = 0; n < kStates; ++n) {
    const SampledState<Model> at(sample, 1.0);
    std::vector<double> mine = engine_accelerations(at);
    mine.erase(mine.begin(), mine.end() - static_cast<std::ptrdiff_t>(at.kJoints));
    worst = std::max(worst, relative_error(mine, of_mujoco(*model, *data, at)));
  }
  std::printf("%d joints, worst %.1e\n", model->njnt, worst);
  mj_deleteData(data);
  mj_deleteModel(model);
}

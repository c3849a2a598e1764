// Accelerations of MultibodyEngine against MuJoCo's at random states, in double and in float. With
// `--table FILE`, writes those of MuJoCo that tests/unit/multibody compares without it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "tests/mujoco/plant.hpp"
#include "tests/unit/multibody/sampled_state.hpp"

namespace {

using namespace eagerx::models;
using namespace eagerx::models::testing;
using eagerx::mujoco::Plant;

constexpr int kStates = 1000;
constexpr std::size_t kTableStates = 3;
constexpr double kBoundInDouble = 1e-9, kBoundInFloat = 5e-5;

/// In the order of engine_accelerations().
template <class Model>
std::vector<double> mujoco_accelerations(Plant<Model>& plant, const SampledState<Model>& at) {
  mjData& data = *plant.data;
  std::fill_n(data.qfrc_applied, plant.model->nv, 0.0);
  if constexpr (SampledState<Model>::kFloating) {
    std::copy_n(&at.pose[0], 7, data.qpos);
    mju_normalize4(data.qpos + 3);
    std::copy_n(&at.twist[0], 3, data.qvel);
    double back[4];
    mju_negQuat(back, data.qpos + 3);
    mju_rotVecQuat(data.qvel + 3, &at.twist[3], back);  // of the body
  }
  for (std::size_t j = 0; j < at.kJoints; ++j) {
    if (plant.position_of(j) < 0) continue;
    data.qpos[plant.position_of(j)] = at.q[j];
    data.qvel[plant.velocity_of(j)] = at.v[j];
    data.qfrc_applied[plant.velocity_of(j)] = at.torque[j];
  }
  mj_forward(plant.model, plant.data);
  std::vector<double> result;
  if constexpr (SampledState<Model>::kFloating) {
    double turn[3];
    mju_rotVecQuat(turn, data.qacc + 3, data.qpos + 3);
    result.assign(data.qacc, data.qacc + 3);
    result.insert(result.end(), turn, turn + 3);
  }
  for (std::size_t j = 0; j < at.kJoints; ++j) {
    if (plant.velocity_of(j) >= 0) result.push_back(data.qacc[plant.velocity_of(j)]);
  }
  return result;
}

struct Errors {
  std::vector<double> of_state{};
  double worst() const { return *std::max_element(of_state.begin(), of_state.end()); }
  double median() {
    std::nth_element(of_state.begin(), of_state.begin() + kStates / 2, of_state.end());
    return of_state[kStates / 2];
  }
};

template <class Model>
Errors errors_of(const std::vector<std::vector<double>>& expected, double most_torque) {
  Sampler sample;
  Errors errors;
  for (const auto& one : expected)
    errors.of_state.push_back(
        relative_error(engine_accelerations(SampledState<Model>(sample, most_torque)), one));
  return errors;
}

/// Whether the robot is within the bounds.
template <template <class> class Model>
bool compare(std::FILE* table) {
  using Robot = ComparedRobot<Model>;
  Plant<Model<double>> plant({});
  Sampler sample;
  std::vector<std::vector<double>> expected;
  for (int n = 0; n < kStates; ++n)
    expected.push_back(
        mujoco_accelerations(plant, SampledState<Model<double>>(sample, Robot::kMostTorque)));
  for (std::size_t n = 0; table != nullptr && n < kTableStates; ++n) {
    std::fprintf(table, "%s", Robot::kName);
    for (const double a : expected[n]) std::fprintf(table, ",%.17g", a);
    std::fprintf(table, "\n");
  }
  Errors in_double = errors_of<Model<double>>(expected, Robot::kMostTorque);
  Errors in_float = errors_of<Model<float>>(expected, Robot::kMostTorque);
  std::printf(
      "%-10s %2d joints   double: worst %.1e, median %.1e   float: worst %.1e, median %.1e\n",
      Robot::kName, plant.model->nv - (SampledState<Model<double>>::kFloating ? 6 : 0),
      in_double.worst(), in_double.median(), in_float.worst(), in_float.median());
  return in_double.worst() < kBoundInDouble && in_float.worst() < kBoundInFloat;
}

}  // namespace

int main(int argc, char** argv) {
  const bool writes = argc == 3 && std::strcmp(argv[1], "--table") == 0;
  if (argc != 1 && !writes) {
    std::fprintf(stderr, "usage: mujoco_accelerations [--table FILE]\n");
    return 2;
  }
  std::FILE* const table = writes ? std::fopen(argv[2], "w") : nullptr;
  if (writes && table == nullptr) {
    std::perror(argv[2]);
    return 2;
  }
  std::printf("MuJoCo %s, %d random states: difference of accelerations, of the largest\n",
              mj_versionString(), kStates);
  bool good = compare<FreeArm>(table);
  good = compare<FreeQuadruped>(table) && good;
  good = compare<Humanoid>(table) && good;
  good = compare<Hand>(table) && good;
  if (table != nullptr && std::fclose(table) != 0) return 2;
  std::printf("%s: %.0e in double, %.0e in float\n", good ? "within" : "NOT WITHIN", kBoundInDouble,
              kBoundInFloat);
  return good ? 0 : 1;
}

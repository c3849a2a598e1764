// Accelerations that MuJoCo 2.2.2 printed: `tests/mujoco/run` compares 1,000 states of each robot
// with it, and mujoco.csv has the first three.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/unit/multibody/sampled_state.hpp"

namespace eagerx::models::testing {

using MujocoTable = std::map<std::string, std::vector<std::vector<double>>>;

/// Robot: accelerations at each state.
inline MujocoTable mujoco_table() {
  MujocoTable table;
  std::ifstream file(EAGERX_SOURCE_DIR "/tests/unit/multibody/mujoco.csv");
  for (std::string line, field; std::getline(file, line);) {
    std::istringstream fields(line);
    std::getline(fields, field, ',');
    auto& row = table[field].emplace_back();
    while (std::getline(fields, field, ',')) row.push_back(std::stod(field));
  }
  return table;
}

/// Of the engine at the table's states of a robot; 1 if there are none.
template <template <class> class Model, class Robot = ComparedRobot<Model>>
double worst_error(const MujocoTable& table) {
  const auto rows = table.find(Robot::kName);
  if (rows == table.end()) return 1.0;
  Sampler sample;
  double worst = 0.0;
  for (const auto& expected : rows->second)
    worst = std::max(worst, relative_error(engine_accelerations(SampledState<Model<double>>(
                                               sample, Robot::kMostTorque)),
                                           expected));
  return worst;
}

}  // namespace eagerx::models::testing

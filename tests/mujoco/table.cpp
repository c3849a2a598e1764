// Accelerations of a humanoid and a hand against the table of MuJoCo's, without MuJoCo.
#include <cstdio>

#include "tests/unit/multibody/mujoco_table.hpp"

int main() {
  using namespace eagerx::models::testing;
  const MujocoTable table = mujoco_table();
  const double humanoid = worst_error<Humanoid>(table), hand = worst_error<Hand>(table);
  std::printf("accelerations against MuJoCo's: humanoid %.1e, hand %.1e\n", humanoid, hand);
  return humanoid < 1e-12 && hand < 1e-12 ? 0 : 1;
}

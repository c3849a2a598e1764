// Accelerations of two robots against a table of MuJoCo's. tests/mujoco/table.cpp does larger ones,
// which take longer to compile.
#include <gtest/gtest.h>

#include "tests/unit/multibody/mujoco_table.hpp"

namespace eagerx::models::testing {
namespace {

TEST(MultibodyMujoco, AccelerationsAreThoseOfMujoco) {
  const MujocoTable table = mujoco_table();
  EXPECT_LT(worst_error<FreeArm>(table), 1e-12);
  EXPECT_LT(worst_error<FreeQuadruped>(table), 1e-12);
}

}  // namespace
}  // namespace eagerx::models::testing

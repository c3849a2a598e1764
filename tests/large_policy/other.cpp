#include "pendulum_swing_up/policy.hpp"

const void* table_of_other_file();
bool other_file_answers();

const void* table_of_other_file() {
  return &graphs::pendulum_swing_up::policy::kLayer2;
}
bool other_file_answers() {
  return graphs::pendulum_swing_up::policy::self_test();
}

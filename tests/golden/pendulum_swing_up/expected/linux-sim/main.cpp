// The program of graph `pendulum_swing_up` on linux-sim. `--help` lists its options; the loop is in
// targets/linux-sim/app.hpp.
#include <targets/linux-sim/app.hpp>

#include "pendulum_swing_up/graph.hpp"

int main(int argc, char** argv) {
  return eagerx::linux_sim::run<graphs::pendulum_swing_up::Graph>(argc, argv);
}

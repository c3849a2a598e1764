// The program of graph `multi_rate` on linux-sim. `--help` lists its options; the loop is in
// targets/linux-sim/app.hpp.
#include <targets/linux-sim/split_app.hpp>

#include "multi_rate/graph.hpp"

int main(int argc, char** argv) {
  return eagerx::linux_sim::run<graphs::multi_rate::Graph>(argc, argv);
}

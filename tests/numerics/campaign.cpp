// Every block of the library in float against double, from tick 2^26 on: a line for each, and exit
// code 1 if one is farther from double than its bound. Argument: ticks, 2^26 of them if there is
// none.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/unit/models/block_table.hpp"

int main(int argc, char** argv) {
  using namespace eagerx::models::testing::long_runs;
  constexpr eagerx::Seq kStart = eagerx::Seq{1} << 26;
  const eagerx::Seq ticks = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : kStart;
  int failures = 0;
  std::printf("| block | float from double | bound |\n|---|---|---|\n");
  for (const Row& row : kBlocks) {
    const double error = row.error(kStart, ticks);
    const bool good = error <= row.bound;
    std::printf("| %s%s%s | %.1e | %.0e%s |\n", row.folder.data(), row.what.empty() ? "" : ", ",
                row.what.data(), error, row.bound, good ? "" : " exceeded");
    std::fflush(stdout);
    failures += good ? 0 : 1;
  }
  return failures == 0 ? 0 : 1;
}

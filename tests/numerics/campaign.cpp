// Every block of the library in float against double, from tick 2^26 on: a line for each, and exit
// code 1 if one is farther from double than its bound. Argument: ticks; 2^26 of them without.
// With two, NUMBER TICKS, it only calls that block of the table (tests/bench/blocks counts what it
// takes), and says its name and bytes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/unit/models/block_table.hpp"

namespace {

using namespace eagerx::models::testing::long_runs;

std::string name_of(const Row& row) {
  return std::string(row.folder) + (row.what.empty() ? "" : ", ") + std::string(row.what);
}

int spend(std::size_t number, eagerx::Seq ticks) {
  if (number >= kBlocks.size()) return 2;
  const Row& row = kBlocks[number];
  row.spend(ticks);
  std::printf("%s: %zu\n", name_of(row).c_str(), row.bytes);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3)
    return spend(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10));
  constexpr eagerx::Seq kStart = eagerx::Seq{1} << 26;
  const eagerx::Seq ticks = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : kStart;
  int failures = 0;
  std::printf("| block | float from double | bound |\n|---|---|---|\n");
  for (const Row& row : kBlocks) {
    const double error = row.error(kStart, ticks);
    const bool good = error <= row.bound;
    std::printf("| %s | %.1e | %.0e%s |\n", name_of(row).c_str(), error, row.bound,
                good ? "" : " exceeded");
    std::fflush(stdout);
    failures += good ? 0 : 1;
  }
  return failures == 0 ? 0 : 1;
}

// nodes_bench STEPS REPEATS: ns a step of both programs.
// nodes_bench STEPS generated|by_hand: one run, for counting instructions.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "../timing.hpp"
#include "loops.hpp"

int main(int argc, char** argv) {
  using namespace eagerx::bench;
  if (argc != 3) return 2;
  const std::uint64_t steps = std::strtoull(argv[1], nullptr, 10);
  const std::string_view what = argv[2];
  std::uint32_t seen = 0;
  if (what == "generated" || what == "by_hand") {
    seen = what == "generated" ? run_generated(steps) : run_by_hand(steps);
    std::printf("seen %u\n", seen);
    return 0;
  }
  const Best best = time_in_turn(
      std::atoi(argv[2]), [&] { seen += run_generated(steps); },
      [&] { seen += run_by_hand(steps); });
  const auto count = static_cast<double>(steps);
  std::printf("generated_ns %.1f\nby_hand_ns %.1f\nseen %u\n", best.first_ns / count,
              best.second_ns / count, seen);
  return 0;
}

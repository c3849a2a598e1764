// pendulum_bench STEPS REPEATS: ns a step of both programs.
// pendulum_bench STEPS generated|by_hand policy|zero: one run, for counting instructions.
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "../timing.hpp"
#include "loops.hpp"

namespace {

using eagerx::bench::Seen;

bool same_bits(const Seen& a, const Seen& b) {
  const auto same = [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  };
  return same(a.cosine, b.cosine) && same(a.sine, b.sine) && same(a.theta_dot, b.theta_dot);
}

/// False if the two programs do not end with the same bits.
bool measure(const char* name, bool policy, std::uint64_t steps, int repeats) {
  Seen generated{};
  Seen by_hand{};
  const auto best = eagerx::bench::time_in_turn(
      repeats, [&] { generated = eagerx::bench::run_generated(policy, steps); },
      [&] { by_hand = eagerx::bench::run_by_hand(policy, steps); });
  const auto count = static_cast<double>(steps);
  std::printf("%s_generated_ns %.3f\n%s_by_hand_ns %.3f\n", name, best.first_ns / count, name,
              best.second_ns / count);
  if (same_bits(generated, by_hand)) return true;
  std::fprintf(stderr, "%s: generated ends at %a %a %a, by hand at %a %a %a\n", name,
               generated.cosine, generated.sine, generated.theta_dot, by_hand.cosine, by_hand.sine,
               by_hand.theta_dot);
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) return 2;
  const std::uint64_t steps = std::strtoull(argv[1], nullptr, 10);
  if (argc == 3) {
    const int repeats = std::atoi(argv[2]);
    const bool policy = measure("policy", true, steps, repeats);
    return measure("zero", false, steps, repeats) && policy ? 0 : 1;
  }
  const bool policy = std::string_view(argv[3]) == "policy";
  const bool generated = std::string_view(argv[2]) == "generated";
  const Seen seen = generated ? eagerx::bench::run_generated(policy, steps)
                              : eagerx::bench::run_by_hand(policy, steps);
  std::printf("%a\n", seen.theta_dot);
  return 0;
}

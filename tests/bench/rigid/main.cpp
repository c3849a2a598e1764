// rigid_bench STEPS REPEATS: ns a step of both programs of both scenes.
#include <ode/ode.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "../timing.hpp"
#include "loops.hpp"

namespace {

using eagerx::bench::Seen;

/// False if the two programs do not see the same scene: after ten steps, before chaos and rounding
/// of different calls count.
template <class Generated, class ByHand>
bool measure(const char* name, Generated&& generated, ByHand&& by_hand, std::uint64_t steps,
             int repeats) {
  constexpr std::uint64_t kFew = 10;
  constexpr float kTolerance = 1e-4F;
  const Seen one = generated(kFew), other = by_hand(kFew);
  const auto best = eagerx::bench::time_in_turn(
      repeats, [&] { generated(steps); }, [&] { by_hand(steps); });
  const auto count = static_cast<double>(steps);
  std::printf("%s_generated_ns %.3f\n%s_by_hand_ns %.3f\n", name, best.first_ns / count, name,
              best.second_ns / count);
  if (std::abs(one - other) < kTolerance) return true;
  std::fprintf(stderr, "%s: generated is at %g, by hand at %g\n", name, static_cast<double>(one),
               static_cast<double>(other));
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::uint64_t steps = std::strtoull(argv[1], nullptr, 10);
  const int repeats = std::atoi(argv[2]);
  using namespace eagerx::bench;
  dInitODE2(0);
  const bool pendulum = measure("pendulum", pendulum_generated, pendulum_by_hand, steps, repeats);
  return measure("box", box_generated, box_by_hand, steps, repeats) && pendulum ? 0 : 1;
}

// Ten thousand faults for each of two controllers; prints what came of them.
#include "../faults.hpp"
#include "arm.hpp"
#include "servo.hpp"

#ifdef ON_BOARD
#include <targets/common/bare-metal/console.hpp>
static void say(const char* name, unsigned long long value) {
  eagerx::board::console.text(name);
  eagerx::board::console.text(" ");
  eagerx::board::console.number(value);
  eagerx::board::console.text("\n");
}
#else
#include <cstdio>
static void say(const char* name, unsigned long long value) {
  std::printf("%s %llu\n", name, value);
}
#endif

static constexpr std::uint32_t kFaults = 10'000;
static constinit graphs::servo::Program<own_loop::CountingTrace> servo{};
static constinit graphs::arm::Program<own_loop::CountingTrace> arm{};

template <class Limits, class Program>
static bool try_faults(Program& program, std::uint32_t frozen_after) {
  const own_loop::Report report =
      own_loop::Trial<Limits, Program>(program, frozen_after).run(kFaults);
  say("faults", report.faults);
  say("steps", report.steps);
  say("violations", report.violations);
  say("hash", report.hash);
  return report.violations == 0;
}

int main() {
  const bool right = try_faults<graphs::servo::Limits>(servo, 6);
  const bool both = try_faults<graphs::arm::Limits>(arm, 5) && right;
#ifdef ON_BOARD
  eagerx::board::console.flush();
#endif
  return both ? 0 : 1;
}

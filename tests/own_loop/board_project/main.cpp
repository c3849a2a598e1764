// Ten thousand faults for each of two controllers; prints what came of them.
#include "../faults.hpp"
#include "../floats.hpp"
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
static constinit graphs::servo::Program<own_loop::CountingHooks> servo{};
static constinit graphs::arm::Program<own_loop::CountingHooks> arm{};

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

/// The answer to a loop that asks before it begins.
template <class Graph>
static bool try_floats() {
  const bool as_it_is = Graph::self_test();
  own_loop::flush_denormals(true);
  const bool flushing = Graph::self_test();
  const bool answers = Graph::policies_answer();
  own_loop::flush_denormals(false);
  const bool again = Graph::self_test();
  say("self-test", as_it_is);
  say("self-test flushing", flushing);
  say("self-test again", again);
  return as_it_is && !flushing && answers && again;
}

int main() {
  const bool floats = try_floats<graphs::servo::Graph>();
  const bool right = try_faults<graphs::servo::Limits>(servo, 6);
  const bool both = try_faults<graphs::arm::Limits>(arm, 5) && right;
#ifdef ON_BOARD
  eagerx::board::console.flush();
#endif
  return both && floats ? 0 : 1;
}

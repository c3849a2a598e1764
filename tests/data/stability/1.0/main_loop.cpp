// A main loop of a user, with the library of graphs/own.yaml: what it may call. It must compile.
#include <cstdint>

#include "own.hpp"

namespace {

using graphs::own::Action;
using graphs::own::Graph;
using graphs::own::Observation;
using graphs::own::Program;

/// Hooks of a user, which see every message.
struct Hooks {
  std::uint64_t messages = 0;

  void on_episode(std::uint32_t /*index*/) {}
  template <class Message>
  void on_message(std::uint32_t /*channel*/, eagerx::Seq /*seq*/, const Message& /*message*/) {
    ++messages;
  }
};

Program<> program;
Program<eagerx::HashTrace> traced;
Program<Hooks> hooked;

float run() {
  if (!Graph::self_test() || !eagerx::calculates_as_everywhere()) return 0.0F;
  const eagerx::EpisodeKey key{.seed = 1, .environment = 0, .episode = 0};
  Observation seen = program.reset(Graph::sample(key));
  program.reset({});
  Action action = Graph::zero();
  action.angle[0] = 0.5F;
  action.angle = {0.5F, -0.5F};
  seen = program.step(action);
  seen = program.step(action, 0);
  seen = program.step_without(1);
  seen = program.step_safely();
  float sum = seen.force.size() > 0 ? seen.force.back()[0] + seen.force[0][1] : 0.0F;
  if (program.guard.acts()) sum += 1.0F;
  program.guard.for_each_count(
      [&](const char* /*name*/, std::uint64_t count) { sum += static_cast<float>(count); });
  traced.reset({});
  traced.step(action);
  hooked.reset({});
  hooked.step(action);
  return sum +
         static_cast<float>(traced.hooks.hash() + hooked.hooks.messages +
                            program.steps_before_reset() + Graph::kGraphHash + Graph::kPolicyHash);
}

}  // namespace

int main() {
  return run() != 0.0F ? 0 : 1;
}

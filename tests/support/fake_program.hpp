// A program of no graph, for tests of what the library of linux-sim makes of one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/message.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/message_view.hpp>

namespace eagerx::linux_sim {

struct FakeAction {
  Array<float, 2> push;
  std::int64_t choice;
  bool on;
};

/// Fields of several types, whose names are not in the order of the alphabet.
class FakeProgram final : public GraphProgram {
 public:
  GraphFacts known{};
  bool moves_hardware = false;

  FakeProgram() {
    known.name = "fake";
    known.engine = "none";
    known.rate_num = 1'000'000;
    known.rate_den = 1;
    known.safety.declared = true;
    known.safety.late = 2;
  }

  const GraphFacts& facts() const override { return known; }
  void list_fields(FieldListener& listener) const override {
    static constexpr Array<float, 2> kLow{-1.0F, -2.0F}, kHigh{1.0F, 2.0F};
    static constexpr double kLeast = 0.0, kMost = 0.5;
    Field push{"push", TypeOf<Array<float, 2>>::value, &kLow, &kHigh};
    push.offset = offsetof(FakeAction, push);
    Field choice{"choice", TypeOf<std::int64_t>::value};
    choice.offset = offsetof(FakeAction, choice);
    Field on{"on", TypeOf<bool>::value};
    on.offset = offsetof(FakeAction, on);
    for (const Field& each : {push, choice, on}) listener.action(each);
    Field seen{"seen", TypeOf<Array<float, 2>>::value};
    seen.most = 3;
    seen.varies = true;
    Field count{"count", TypeOf<std::uint8_t>::value};
    for (const Field& each : {seen, count}) listener.observation(each);
    listener.state({"delay", TypeOf<double>::value, &kLeast, &kMost});
    static constexpr Array<float, 2> kBack{-9.0F, -9.0F}, kFront{9.0F, 9.0F};
    Field at{"at", TypeOf<Array<float, 2>>::value, &kBack, &kFront};
    at.tunable = true;
    listener.state(at);
    listener.outcome("reward", false);
    listener.outcome("terminated", true);
    listener.outcome("effort", false);
  }
  bool policies_answer() const override { return true; }
  bool rounds_each_operation() const override { return true; }
  bool is_real() const override { return moves_hardware; }
  Pictures* pictures() const override { return nullptr; }
  SplitLink* link(std::size_t /*part*/) override { return nullptr; }
  void run(Watch& /*watch*/, bool /*traced*/) override {}
  void list_counts(bool /*traced*/, CountListener& listener) const override {
    listener.count("a \"count\"", 3);
    listener.count("none", 0);
  }
  std::uint64_t hash() const override { return 42; }
  std::size_t action_bytes() const override { return sizeof(FakeAction); }
  void zero(void* action) const override { *static_cast<FakeAction*>(action) = {}; }
  void sample(EpisodeKey /*key*/, StateRow states) const override {
    states.has_value[0] = true;  // the delay is sampled
    *static_cast<double*>(states.messages[0]) = 0.25;
  }
  void warm_up() override {}
  void reset(std::uint32_t /*episode*/, StateRow /*states*/) override {}
  void act(target::Agent /*agent*/, EpisodeKey /*key*/, Seq /*step*/, void* /*action*/) override {}
  void tune(StateRow /*states*/) override {}
  void guard(void* /*action*/) override {}
  void apply(void* /*action*/) override {}
};

}  // namespace eagerx::linux_sim

// eagerx/guard.hpp: when the safe action takes the agent's place, and when it ends.
#include <gtest/gtest.h>

#include <array>
#include <eagerx/guard.hpp>
#include <limits>
#include <map>
#include <string>

namespace eagerx {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

template <Safety kDeclared>
struct FakeLimits {
  struct Action {
    float volt;
    std::int32_t gear;
  };
  struct Observation {
    float angle;
  };
  struct OneMessage {
    float value;
    static constexpr std::uint32_t size() { return 1; }
    float operator[](std::uint32_t /*i*/) const { return value; }
  };
  static constexpr Safety kSafety = kDeclared;
  static constexpr std::array<const char*, 2> kActionNames{"volt", "gear"};
  static constexpr std::array<const char*, 1> kObservationNames{"angle"};
  static constexpr std::array<bool, 1> kMayWait{false};
  static Action safe() { return {0.5F, 1}; }
  template <class F>
  static void for_each_action(Action& action, F&& f) {
    f("volt", action.volt, Space<float>{-2.0F, 2.0F});
    f("gear", action.gear, Space<std::int32_t>{0, 5});
  }
  template <class F>
  static void for_each_applied(Action& action, F&& f) {
    f(action.volt, Space<float>{-1.9F, 3.0F});  // of an actuator
    f(action.gear, Space<std::int32_t>{0, 5});
  }
  template <class F>
  static void for_each_observation(const Observation& observation, F&& f) {
    f("angle", OneMessage{observation.angle}, Space<float>{-4.0F, 4.0F});
  }
};

constexpr Safety kUsual{.declared = true,
                        .late = 2,
                        .max_lateness_ns = 0,
                        .link_timeout_ns = 10'000'000,
                        .heartbeat_timeout_ns = 500'000'000,
                        .missed = 3,
                        .recover = 2,
                        .clips = true,
                        .holds = false};
constexpr Safety with(bool declared, std::uint32_t recover, bool clips, bool holds) {
  Safety safety = kUsual;
  safety.declared = declared;
  safety.recover = recover;
  safety.clips = clips;
  safety.holds = holds;
  return safety;
}

template <Safety kDeclared>
struct Guarded {
  Guard<FakeLimits<kDeclared>> guard;

  Guarded() { guard.reset(); }
  float volt(float wanted, float angle = 0.0F, std::uint64_t late = 0) {
    guard.see({angle});
    return guard.check({wanted, 2}, late).volt;
  }
  std::map<std::string, std::uint64_t> counts() const {
    std::map<std::string, std::uint64_t> result;
    guard.for_each_count([&](const char* name, std::uint64_t count) { result[name] = count; });
    return result;
  }
};

TEST(GuardTest, WithoutSafetyOnlyWhatNoActuatorTakesIsChanged) {
  Guarded<with(false, 2, true, false)> run;
  EXPECT_EQ(run.volt(1.5F, kNaN, 9), 1.5F) << "neither NaN before it nor lateness";
  for (const auto& [name, count] : run.counts()) EXPECT_EQ(count, 0U) << name;
  EXPECT_EQ(run.volt(7.0F), 2.0F);
  EXPECT_EQ(run.counts()["safe: action out of limits: volt"], 1U);
  EXPECT_EQ(run.volt(kNaN), 0.5F);
  EXPECT_EQ(run.volt(-std::numeric_limits<float>::infinity()), 0.5F);
  EXPECT_EQ(run.counts()["safe: action not finite: volt"], 2U);
  EXPECT_EQ(run.volt(-1.95F), -1.9F);
  EXPECT_EQ(run.counts()["safe: action beyond its actuator: volt"], 1U);
  EXPECT_EQ(run.volt(1.0F), 1.0F);
}

TEST(GuardTest, WithinAnActuatorsSpaceAfterAProcessor) {
  Guarded<kUsual> run;
  const Space<float> space{1.0F, 2.0F};
  EXPECT_EQ(run.guard.within(0, space, 1.5F), 1.5F);
  EXPECT_EQ(run.guard.within(0, space, 3.0F), 2.0F);
  EXPECT_EQ(run.guard.within(0, space, kNaN), 1.0F) << "zero, moved into it";
  EXPECT_EQ(run.counts()["safe: action beyond its actuator: volt"], 2U);
}

TEST(GuardTest, LimitsClip) {
  Guarded<kUsual> run;
  EXPECT_EQ(run.volt(7.0F), 2.0F);
  EXPECT_EQ(run.volt(1.0F), 1.0F);
  EXPECT_EQ(run.counts()["safe: action out of limits: volt"], 1U);
  EXPECT_EQ(run.counts()["safe: steps"], 0U);
}

TEST(GuardTest, LimitsMakeSafe) {
  Guarded<with(true, 2, false, false)> run;
  EXPECT_EQ(run.volt(7.0F), 0.5F);
  EXPECT_EQ(run.volt(1.0F), 0.5F) << "the first right one";
  EXPECT_EQ(run.volt(1.0F), 1.0F) << "the second";
  EXPECT_EQ(run.counts()["safe: steps"], 2U);
  EXPECT_EQ(run.counts()["safe: times"], 1U);
}

TEST(GuardTest, NaNMakesSafeAtOnceAndIsCountedOnce) {
  Guarded<kUsual> run;
  EXPECT_EQ(run.volt(kNaN, kNaN), 0.5F);
  EXPECT_EQ(run.volt(std::numeric_limits<float>::infinity()), 0.5F);
  EXPECT_EQ(run.counts()["safe: observation not finite: angle"], 1U);
  EXPECT_EQ(run.counts()["safe: action not finite: volt"], 1U) << "not the answer to NaN";
  run.guard.reset();
  EXPECT_EQ(run.volt(1.0F), 1.0F) << "another episode";
}

TEST(GuardTest, TheActionBeforeIsHeldForSomeInstants) {
  Guarded<with(true, 1, true, true)> run;
  EXPECT_EQ(run.volt(1.5F), 1.5F);
  EXPECT_EQ(run.volt(kNaN), 1.5F);
  EXPECT_EQ(run.volt(kNaN), 1.5F);
  EXPECT_EQ(run.volt(kNaN), 0.5F) << "three in a row";
  EXPECT_EQ(run.volt(1.0F), 1.0F);
  EXPECT_EQ(run.volt(kNaN), 1.0F);
}

TEST(GuardTest, HoldsAndStrictLimits) {
  Guarded<with(true, 1, false, true)> run;
  EXPECT_EQ(run.volt(1.5F), 1.5F);
  EXPECT_EQ(run.volt(kNaN), 1.5F);
  EXPECT_EQ(run.volt(3.0F), 0.5F);
}

TEST(GuardTest, OverrunsMakeSafe) {
  Guarded<kUsual> run;
  EXPECT_EQ(run.volt(1.0F, 0.0F, 1), 1.0F);
  EXPECT_EQ(run.volt(1.0F, 0.0F, 2), 0.5F);
  EXPECT_EQ(run.volt(1.0F, 0.0F, 0), 0.5F);
  EXPECT_EQ(run.volt(1.0F, 0.0F, 0), 1.0F);
  EXPECT_EQ(run.counts()["safe: overrun"], 1U);
}

TEST(GuardTest, SafeUntilTheNextEpisode) {
  Guarded<with(true, 0, true, false)> run;
  EXPECT_EQ(run.volt(kNaN), 0.5F);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(run.volt(1.0F), 0.5F);
  run.guard.reset();
  EXPECT_EQ(run.volt(1.0F), 1.0F);
  EXPECT_EQ(run.guard.stop().gear, 1);
  EXPECT_EQ(run.counts()["safe: stopped"], 1U);
}

}  // namespace
}  // namespace eagerx

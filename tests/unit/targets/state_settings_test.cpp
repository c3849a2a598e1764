// --set: states at resets, and parameters while an episode runs.
#include <gtest/gtest.h>

#include <string>
#include <targets/linux-sim/state_record.hpp>
#include <targets/linux-sim/state_settings.hpp>
#include <tests/support/fake_program.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

class Settings : public testing::Test {
 protected:
  const FakeProgram program;
  const Fields fields{program};
  StateSettings settings{fields.states};
  const StateMemory states{fields.states};

  float at(std::size_t i) const { return static_cast<const float*>(states.row().messages[1])[i]; }
};

TEST_F(Settings, AParameterIsSetBeforeItsStepAlone) {
  ASSERT_EQ(settings.read({"at=1", "at=2,3@5", "at=4@18446744073709551615"}), "");
  EXPECT_TRUE(settings.tunes());
  ASSERT_TRUE(settings.apply({1, 0, 0}, states.row()));
  EXPECT_EQ(at(1), 1.0F);
  for (const Seq step : {0U, 4U, 6U}) EXPECT_FALSE(settings.apply_at(step, states.row())) << step;
  ASSERT_TRUE(settings.apply_at(5, states.row()));
  EXPECT_EQ(at(0), 2.0F);
  EXPECT_EQ(at(1), 3.0F);
  EXPECT_FALSE(states.row().has_value[0]);
}

TEST_F(Settings, OfTwoAtOneStepTheLastOneCounts) {
  ASSERT_EQ(settings.read({"at=2@5", "at=7@5"}), "");
  ASSERT_TRUE(settings.apply_at(5, states.row()));
  EXPECT_EQ(at(0), 7.0F);
  EXPECT_FALSE(StateSettings(fields.states).tunes());
}

TEST_F(Settings, WhatAnEpisodeCannotChangeIsRefused) {
  EXPECT_EQ(settings.read({"delay=0.1@5"}),
            "error: `delay=0.1@5`: `delay` can be set at a reset, not while an episode runs\n"
            "help: leave out `@5`; while it runs one can set at");
  for (const char* text : {"at=1@", "at=1@-1", "at=1@1.5", "at=1@18446744073709551616", "at=@1",
                           "at=uniform:1,2@3", "at=1@2@3"}) {
    EXPECT_NE(settings.read({text}).find("is not a setting"), std::string::npos) << text;
  }
}

TEST_F(Settings, ALogRepeatsWhatWasSetBeforeAStep) {
  trace_log::Log log;
  log.settings = {{0, 5, "at", {"1", "2"}}, {0, 5, "gone", {"1"}}, {1, 5, "at", {"3", "4"}}};
  // A fake has no ids.
  std::vector<Field> named = fields.states;
  named[1].id = "at";
  EXPECT_FALSE(repeat_settings(log, 0, 4, named, states.row()));
  ASSERT_TRUE(repeat_settings(log, 1, 5, named, states.row()));
  EXPECT_EQ(at(1), 4.0F);
  EXPECT_FALSE(states.row().has_value[0]);
}

TEST(StateSettingTest, Forms) {
  const auto setting = parse_setting("a.b=uniform:0.1,0.2");
  ASSERT_TRUE(setting);
  EXPECT_EQ(setting->name, "a.b");
  EXPECT_EQ(setting->number(0, 5), 0.1);
  EXPECT_EQ(setting->number(1, 5), 0.2);
  const auto lists = parse_setting("a.b=normal:1,2,3,4");
  ASSERT_TRUE(lists);
  EXPECT_EQ(lists->number(0, 1), 2.0);
  EXPECT_EQ(lists->number(1, 0), 3.0);
  for (const char* wrong : {"", "a.b", "=1", "a.b=", "a.b=x", "a.b=1,", "a.b=uniform:", "a.b=inf",
                            "a.b=1 ", "a.b=nan", "a.b=gauss:1,2"})
    EXPECT_FALSE(parse_setting(wrong)) << wrong;
}

TEST(StateSettingTest, NumbersAreWithinTheSpace) {
  const std::vector<double> low = {0.0, -1.0};
  const std::vector<double> high = {1.0, 1.0};
  const auto problem = [&](const char* text) {
    return problem_of(*parse_setting(text), low, high);
  };
  EXPECT_EQ(problem("a=0.5"), "");
  EXPECT_EQ(problem("a=0.5,-0.5"), "");
  EXPECT_NE(problem("a=-0.5").find("-0.5 is out of the space"), std::string::npos);
  EXPECT_NE(problem("a=1,2,3").find("there are 3 numbers"), std::string::npos);
  EXPECT_EQ(problem("a=uniform:0,1"), "");
  EXPECT_EQ(problem("a=uniform:0,-1,1,0"), "");
  EXPECT_NE(problem("a=uniform:1,0"), "");
  EXPECT_NE(problem("a=uniform:0,1,2"), "");
  EXPECT_NE(problem("a=log_uniform:0,1"), "");
  EXPECT_EQ(problem("a=normal:5,1"), "");
  EXPECT_NE(problem("a=normal:5,-1"), "");
  EXPECT_EQ(problem("a=choice:0,0.5,1"), "");
  EXPECT_NE(problem("a=choice:0,0.5,2"), "");
}

}  // namespace
}  // namespace eagerx::linux_sim

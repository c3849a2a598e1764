// Tables of runs that become transitions.
#include <gtest/gtest.h>

#include <string>

#include "targets/environments/train/sac/log.hpp"
#include "tests/unit/train/sac_common.hpp"

namespace eagerx::train {
namespace {

Description pendulum_description() {
  Description result;
  result.observations = {{.name = "angle", .dtype = "float32", .size = 2, .low = {}, .high = {}},
                         {.name = "speed", .dtype = "float32", .low = {}, .high = {}}};
  result.actions = {{.name = "voltage", .dtype = "float32", .low = {-2}, .high = {2}}};
  return result;
}

struct ReadLog {
  sac::Memory memory{3, 1, 100};
  Sums observations{3}, returns{1}, rewards{2};
  sac::Log log;
  std::string problem;

  explicit ReadLog(const std::string& text) {
    try {
      log = sac::read_log(text, "run.csv", pendulum_description(), 0.5F, memory, observations,
                          returns, rewards);
    } catch (const Problem& what) {
      problem = what.what();
    }
  }
};

TEST(TrainSacLog, RowsBecomeTransitions) {
  const ReadLog read(kHeader + kRows + "1,2,0.2,0.4");  // the program was killed here
  ASSERT_EQ(read.problem, "");
  EXPECT_EQ(read.log.transitions, 3);
  EXPECT_EQ(read.log.left_out, 0);
  ASSERT_EQ(read.memory.size(), 3);
  const sac::Transition first = read.memory.at(0), second = read.memory.at(1),
                        fell = read.memory.at(2);
  EXPECT_EQ(first.observation[2], 0.5F);
  EXPECT_EQ(first.next[0], 0.9F);
  EXPECT_EQ(*first.action, -0.5F);
  EXPECT_EQ(first.reward, -2.0F);
  EXPECT_EQ(second.observation[2], 0.25F);
  EXPECT_EQ(*second.action, 1.0F) << "4 V were more than there may be";
  EXPECT_EQ(second.continues, 1.0F) << "it only ran out of time";
  EXPECT_EQ(fell.observation[2], 7.0F);
  EXPECT_EQ(fell.continues, 0.0F);
  EXPECT_EQ(read.observations.count, 5);
  EXPECT_EQ(read.returns.sum[0], -2.0 + (-2.0 * 0.5 - 3.0) - 10.0);
  EXPECT_EQ(read.rewards.count, 3);
  EXPECT_EQ(read.rewards.sum, (std::vector<double>{-2.0 - 3.0 - 10.0, 2.0}));
}

TEST(TrainSacLog, StepsThatLackNumbersAreLeftOut) {
  std::string rows = kRows;
  rows.replace(rows.find("0.125,4,-3"), 5, "nan");
  const ReadLog read(kHeader + rows + "1,3,0.3,0,0,0,0,0,0,0,0,0\n");
  ASSERT_EQ(read.problem, "");
  EXPECT_EQ(read.log.transitions, 2);
  EXPECT_EQ(read.log.left_out, 2) << "one is nan, one comes after a step that is missing";
}

TEST(TrainSacLog, OtherTablesAreRefused) {
  EXPECT_EQ(ReadLog("").problem, "`run.csv`, line 1: there is no header");
  EXPECT_EQ(ReadLog("a,b\n").problem, "`run.csv`, line 1: there is no column `episode`");
  EXPECT_EQ(ReadLog(kHeader + "0,0\n").problem, "`run.csv`, line 2: 2 cells, not 12");
  std::string wrong = kHeader + kRows;
  wrong.replace(wrong.find("0.25"), 4, "fast");
  EXPECT_EQ(ReadLog(wrong).problem, "`run.csv`, line 3: `fast` is not a number");
  wrong = kHeader + kRows;
  wrong.replace(wrong.find("angle[1]"), 8, "tilt");
  EXPECT_EQ(ReadLog(wrong).problem, "`run.csv`, line 1: there is 1 column of `angle`, not 2");
  EXPECT_EQ(ReadLog(kHeader + "-1,0,0,1,0,0.5,,,,,,\n").problem,
            "`run.csv`, line 2: `-1` is not a whole number");
}

}  // namespace
}  // namespace eagerx::train

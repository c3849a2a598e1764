// Files of actions: what is read, and where mistakes are reported.
#include "targets/linux-sim/action_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/message.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "targets/linux-sim/options.hpp"

namespace eagerx::linux_sim {
namespace {

struct Action {
  Array<float, 2> voltage;
  std::int64_t gear;
};

std::vector<Field> fields() {
  Field voltage{"voltage", TypeOf<Array<float, 2>>::value};
  Field gear{"gear", TypeOf<std::int64_t>::value};
  gear.offset = offsetof(Action, gear);
  return {voltage, gear};
}

class ActionFileTest : public testing::Test {
 protected:
  /// Writes `content` and loads it for an episode of `steps` steps.
  ActionProblem load(const std::string& content, std::uint64_t steps) {
    std::ofstream(path_, std::ios::binary) << content;
    return table_.load(path_, steps);
  }
  /// The problem's text without the file name in front.
  std::string problem(const std::string& content, std::uint64_t steps = 1) {
    const ActionProblem problem = load(content, steps);
    EXPECT_EQ(problem.exit_code, kBadActions);
    return problem.text.substr(std::min(path_.size(), problem.text.size()));
  }
  void TearDown() override { std::filesystem::remove(path_); }

  std::string path_ =
      testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
  Action row(std::uint64_t step) const {
    Action action;
    std::memcpy(&action, table_[step], sizeof action);
    return action;
  }

  Action zero_{};
  std::vector<Field> fields_ = fields();
  ActionTable table_{fields_, &zero_, sizeof zero_};
};

TEST_F(ActionFileTest, ReadsRows) {
  ASSERT_EQ(load("1,-2.5,3\n0.1, 1e-3 ,-4\r\n", 2).exit_code, kDone);
  EXPECT_EQ(row(0).voltage, (Array<float, 2>{1.0F, -2.5F}));
  EXPECT_EQ(row(0).gear, 3);
  EXPECT_EQ(row(1).voltage, (Array<float, 2>{0.1F, 1e-3F}));
  EXPECT_EQ(row(1).gear, -4);
}

TEST_F(ActionFileTest, SkipsTheByteOrderMarkOfSpreadsheets) {
  ASSERT_EQ(load("\xef\xbb\xbfvoltage[0],voltage[1],gear\r\n1,2,3\r\n", 1).exit_code, kDone);
  EXPECT_EQ(row(0).gear, 3);
}

TEST_F(ActionFileTest, SkipsHeaderCommentsAndEmptyLines) {
  ASSERT_EQ(load("# made by hand\nvoltage[0],voltage[1],gear\n\n1,2,3", 1).exit_code, kDone);
  EXPECT_EQ(row(0).gear, 3);
}

TEST_F(ActionFileTest, AHeaderMustBeRight) {
  EXPECT_EQ(problem("voltage,x,gear\n1,2,3\n"),
            ":1:1: error: `voltage` is not a number that `voltage[0]` can hold\n"
            "help: names of columns are `voltage[0],voltage[1],gear`");
}

TEST_F(ActionFileTest, TooFewRows) {
  EXPECT_EQ(problem("1,2,3\n1,2,3\n", 3),
            ":3:1: error: the file ends after 2 actions, but an episode has 3 steps");
  EXPECT_EQ(problem(""), ":1:1: error: the file ends after 0 actions, but an episode has 1 step");
}

TEST_F(ActionFileTest, WrongWidth) {
  EXPECT_EQ(problem("1,2\n"), ":1:3: error: this row has 2 numbers, an action has 3");
  EXPECT_EQ(problem("1,2,3\n1,2,3,4\n"), ":2:7: error: this row has 4 numbers, an action has 3");
}

TEST_F(ActionFileTest, WrongNumbers) {
  EXPECT_EQ(problem("1, x,3\n"), ":1:4: error: `x` is not a number that `voltage[1]` can hold");
  EXPECT_EQ(problem("1,,3\n"), ":1:3: error: `` is not a number that `voltage[1]` can hold");
  EXPECT_EQ(problem("1,nan,3\n"), ":1:3: error: `nan` is not a number that `voltage[1]` can hold");
  EXPECT_EQ(problem("1,1e40,3\n"),
            ":1:3: error: `1e40` is not a number that `voltage[1]` can hold");
  EXPECT_EQ(problem("1,2,3.5\n"), ":1:5: error: `3.5` is not a number that `gear` can hold");
}

TEST_F(ActionFileTest, AFileThatIsNotThere) {
  const ActionProblem problem = table_.load("/nonexistent/actions.csv", 1);
  EXPECT_EQ(problem.exit_code, kBadFile);
  EXPECT_EQ(problem.text,
            "error: cannot read `/nonexistent/actions.csv`: No such file or directory");
}

TEST_F(ActionFileTest, AFolder) {
  EXPECT_EQ(table_.load(testing::TempDir(), 1).exit_code, kBadFile);
}

}  // namespace
}  // namespace eagerx::linux_sim

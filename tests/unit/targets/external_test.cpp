#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <targets/linux-sim/external/external_agent.hpp>
#include <targets/linux-sim/options.hpp>
#include <tests/support/fake_program.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

TEST(ExternalRows, ColumnsAreInTheOrderOfNames) {
  FakeProgram program;
  const Fields fields(program);
  const ExternalRows rows(fields);
  ASSERT_EQ(rows.action_numbers(), 4U);
  const std::array<float, 4> row{7.9F, 1.0F, 0.5F, -0.5F};  // choice, on, push
  FakeAction action{};
  rows.read_action(row.data(), &action);
  EXPECT_EQ(action.choice, 7);
  EXPECT_TRUE(action.on);
  EXPECT_EQ(action.push[1], -0.5F);
  std::array<float, 4> again{};
  rows.write_action(&action, again.data());
  EXPECT_EQ(again, (std::array<float, 4>{7.0F, 1.0F, 0.5F, -0.5F}));
  host::Json json;
  rows.describe_actions(json);
  EXPECT_EQ(
      json.str(),
      R"([{"name": "choice", "shape": [], "dtype": "int64", "window": 1, "low": [null], "high": [null], "first": 0}, )"
      R"({"name": "on", "shape": [], "dtype": "bool", "window": 1, "low": [null], "high": [null], "first": 1}, )"
      R"({"name": "push", "shape": [2], "dtype": "float32", "window": 1, "low": [-1, -2], "high": [1, 2], "first": 2}])");
}

TEST(ExternalRows, MessagesThatAreNotThereAreNoNumbers) {
  FakeProgram program;
  const Fields fields(program);
  const ExternalRows rows(fields);
  std::array<float, 6> seen{1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F};
  std::uint8_t count = 200;
  std::array<void*, 2> messages{seen.data(), &count};
  std::array<std::uint32_t, 2> sizes{2, 0};
  std::vector<float> row(rows.observation_numbers());
  rows.write_observation({messages.data(), sizes.data()}, row.data());
  EXPECT_EQ(row[0], 0.0F);  // count: a type without NaN
  EXPECT_EQ(row[4], 4.0F);
  EXPECT_TRUE(std::isnan(row[5]) && std::isnan(row[6]));
}

TEST(ExternalRows, StatesAreCheckedAndReadAsTheirDecimals) {
  FakeProgram program;
  const Fields fields(program);
  const ExternalRows rows(fields);
  const StateMemory states(fields.states);
  program.sample({}, states.row());
  const bool* const sampled = states.row().has_value;
  const auto problem = [&](std::array<float, 3> row) {  // at, delay
    return rows.problem_of_states(row.data(), sampled);
  };
  EXPECT_EQ(problem({kNone, kNone, kNone}), "");
  EXPECT_EQ(problem({1.0F, kNone, kNone}), "`at` is not sampled: set all of its elements, or none");
  EXPECT_EQ(problem({kNone, kNone, 0.6F}), "`delay` is out of its space: element 0 is 0.6");
  const std::array<float, 3> row{kNone, kNone, 0.1F};
  ASSERT_EQ(rows.problem_of_states(row.data(), sampled), "");
  rows.read_states(row.data(), states.row());
  EXPECT_EQ(*static_cast<double*>(states.row().messages[0]), 0.1);
  EXPECT_FALSE(states.row().has_value[1]);
}

TEST(ExternalProtocol, EachRequestHasItsSize) {
  const auto problem = [](std::uint32_t ask, std::ptrdiff_t behind) {
    const std::size_t bytes = sizeof(Request) + static_cast<std::size_t>(behind);
    return problem_of_request({static_cast<Ask>(ask), 0, 0, 0}, bytes, 4, 3) != nullptr;
  };
  for (std::uint32_t ask = 0; ask < 10; ++ask) EXPECT_TRUE(problem(ask, -1)) << ask;
  EXPECT_FALSE(problem(2, 12));
  EXPECT_TRUE(problem(2, 16));
  EXPECT_FALSE(problem(3, 16));
  EXPECT_TRUE(problem(3, 0));
  EXPECT_TRUE(problem(0, 0));
  EXPECT_FALSE(problem(8, 12));
  EXPECT_TRUE(problem(8, 0));
  EXPECT_TRUE(problem(9, 0));
  for (const std::uint32_t ask : {1U, 4U, 5U, 6U, 7U}) {
    EXPECT_FALSE(problem(ask, 0)) << ask;
    EXPECT_TRUE(problem(ask, 1)) << ask;
  }
}

/// An agent whose program is the test.
class ExternalAgentTest : public testing::Test {
 protected:
  void SetUp() override {
    std::array<int, 2> both{};
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET, 0, both.data()), 0);
    mine = both[0];
    options.agent_socket = both[1];
    options.real_time_factor = 1.0;
  }
  void TearDown() override {
    close(mine);
    close(options.agent_socket);
  }
  void ask(Ask what, const std::vector<float>& row = {}, std::uint32_t number = 0) {
    const Request request{what, number, 9, ++asked};
    std::vector<char> bytes(sizeof request + row.size() * sizeof(float));
    std::memcpy(bytes.data(), &request, sizeof request);
    if (!row.empty())  // data() may be null, which memcpy() must not get
      std::memcpy(bytes.data() + sizeof request, row.data(), row.size() * sizeof(float));
    ASSERT_EQ(send(mine, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  }
  /// The answer, and the text behind it.
  Answer answer(std::string* text = nullptr) const {
    std::vector<char> bytes(std::size_t{1} << 18U);
    const ssize_t got = recv(mine, bytes.data(), bytes.size(), MSG_DONTWAIT);
    Answer result{};
    if (got < static_cast<ssize_t>(sizeof result)) return result;
    std::memcpy(&result, bytes.data(), sizeof result);
    if (text != nullptr) text->assign(bytes.data() + sizeof result, bytes.data() + got);
    return result;
  }

  FakeProgram program;
  Options options;
  const Fields fields{program};
  int mine = -1;
  std::uint64_t asked = 0;  // numbers of requests
  static inline const std::vector<float> kAction{1.0F, 1.0F, 1.0F, 1.0F};
  static inline const std::vector<float> kSampled{kNone, kNone, kNone};
};

TEST_F(ExternalAgentTest, StepsWithoutAnActionAreCountedAndSummed) {
  ExternalAgent agent(options, fields, program, true);
  ASSERT_EQ(agent.open(), "");
  ask(Ask::reset, kSampled, 1);
  ASSERT_TRUE(agent.go_on());
  ASSERT_TRUE(agent.wants_reset());
  EXPECT_EQ(agent.key({1, 2, 7}).seed, 9U);
  EXPECT_EQ(agent.key({1, 2, 7}).episode, 1U);
  agent.reset(0);
  ASSERT_TRUE(agent.go_on());  // answers, and waits 0.8 us without success
  EXPECT_EQ(answer().said, AnswerKind::observation);
  EXPECT_EQ(agent.late_in_a_row(), 1U);
  EXPECT_EQ(static_cast<const FakeAction*>(agent.action())->choice, 0);
  const float effort = -0.5F;
  const OutcomeView outcome{1.5, false, false, true, &effort, Scalar::f32};
  agent.step(1, false, false, outcome);
  ask(Ask::step, kAction);
  ASSERT_TRUE(agent.go_on());
  EXPECT_EQ(agent.late_in_a_row(), 0U);
  EXPECT_EQ(static_cast<const FakeAction*>(agent.action())->choice, 1);
  agent.step(2, true, true, outcome);
  ask(Ask::close);
  EXPECT_FALSE(agent.go_on());
  const Answer seen = answer();
  EXPECT_EQ(seen.step, 2U);
  EXPECT_EQ(seen.late, 1U);
  EXPECT_EQ(seen.reward, 3.0);
  EXPECT_EQ(seen.flags, kTruncated | kSuccess);
  EXPECT_FALSE(agent.leaves_something());
}

TEST_F(ExternalAgentTest, AnEndThatTheAgentWasLateForIsReported) {
  ExternalAgent agent(options, fields, program, true);
  ASSERT_EQ(agent.open(), "");
  ask(Ask::reset, kSampled);
  ASSERT_TRUE(agent.go_on());
  agent.reset(0);
  ASSERT_TRUE(agent.go_on());
  static_cast<void>(answer());
  agent.step(1, true, false, {});
  ask(Ask::step, kAction);
  ask(Ask::step, kAction);
  ask(Ask::reset, kSampled);
  ASSERT_TRUE(agent.go_on());
  const Answer end = answer();
  EXPECT_EQ(end.late, 1U);
  EXPECT_EQ(end.asked, 2U) << "the number of the request that it answers";
  const Answer too_late = answer();
  EXPECT_EQ(too_late.said, AnswerKind::problem);
  EXPECT_EQ(too_late.asked, 3U);
  EXPECT_TRUE(agent.wants_reset());
}

TEST_F(ExternalAgentTest, AnswersQuestionsAndRefusesWhatIsNone) {
  ExternalAgent agent(options, fields, program, true);
  ASSERT_EQ(agent.open(), "");
  for (const Ask what : {Ask::counts, Ask::hash, Ask::picture, Ask::describe}) ask(what);
  ask(Ask::step, {1.0F});
  EXPECT_FALSE(agent.go_on());
  std::string text;
  const std::uint64_t bytes = answer(&text).step;
  EXPECT_EQ(bytes, text.size());
  EXPECT_EQ(text, R"({"a \"count\"": 3})");
  EXPECT_EQ(answer().step, 42U);
  EXPECT_EQ(answer(&text).said, AnswerKind::problem);
  EXPECT_EQ(answer(&text).said, AnswerKind::piece);
  EXPECT_NE(text.find(R"("task": {"terms": ["effort"]})"), std::string::npos) << text;
  EXPECT_NE(agent.problem().find("its row of actions has another size"), std::string::npos);
}

TEST_F(ExternalAgentTest, ParametersAreThoseOfTheNextStep) {
  ExternalAgent agent(options, fields, program, true);
  ASSERT_EQ(agent.open(), "");
  std::string text;
  ask(Ask::tune, {1.0F, 2.0F, kNone});  // at, delay
  ask(Ask::reset, kSampled);
  ASSERT_TRUE(agent.go_on());
  EXPECT_EQ(answer(&text).said, AnswerKind::problem);
  EXPECT_NE(text.find("no episode has begun"), std::string::npos) << text;
  agent.reset(0);
  ask(Ask::tune, {kNone, kNone, 0.1F});
  ask(Ask::tune, {1.0F, kNone, kNone});
  ask(Ask::tune, {1.0F, 2.0F, kNone});
  ask(Ask::step, kAction);
  ASSERT_TRUE(agent.go_on());
  EXPECT_EQ(answer().said, AnswerKind::observation);
  EXPECT_EQ(answer(&text).said, AnswerKind::problem);
  EXPECT_EQ(text, "`delay` can be set at a reset, not while an episode runs");
  EXPECT_EQ(answer(&text).said, AnswerKind::problem);
  EXPECT_NE(text.find("set all of its elements, or none"), std::string::npos) << text;
  EXPECT_EQ(answer().said, AnswerKind::number);
  const StateMemory states(fields.states);
  ASSERT_TRUE(agent.apply_parameters(states.row()));
  EXPECT_FALSE(states.row().has_value[0]);
  EXPECT_EQ(static_cast<const float*>(states.row().messages[1])[1], 2.0F);
  EXPECT_FALSE(agent.apply_parameters(states.row()));
}

TEST_F(ExternalAgentTest, AnAgentThatIsGoneInAnEpisodeLeavesSomething) {
  ExternalAgent agent(options, fields, program, true);
  ASSERT_EQ(agent.open(), "");
  ask(Ask::reset, kSampled);
  ASSERT_TRUE(agent.go_on());
  agent.reset(0);
  shutdown(mine, SHUT_RDWR);
  EXPECT_FALSE(agent.go_on());
  EXPECT_TRUE(agent.leaves_something());
  EXPECT_EQ(agent.problem(), "");
}

TEST_F(ExternalAgentTest, HardwareNeedsToKnowWhatIsLate) {
  program.moves_hardware = true;
  program.known.safety.declared = false;
  ExternalAgent agent(options, fields, program, true);
  EXPECT_NE(agent.open().find("drives real hardware"), std::string::npos);
}

}  // namespace
}  // namespace eagerx::linux_sim

// eagerx/link: frames survive a line that does not; what does not come through ends a run with its
// reason and never as a number.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/unit/runtime/link_line.hpp"

namespace eagerx::link {
namespace {

constexpr std::size_t kToBoard = 24;
constexpr std::size_t kToHost = 16;

using HostEnd = HostLink<HostPort, kToBoard, kToHost>;
using BoardEnd = BoardLink<BoardPort, kToBoard, kToHost>;

class Line : public ::testing::Test {
 protected:
  void start(Identity identity = kIdentity, std::uint8_t status = 0) {
    board_->port.in = &to_board_;
    board_->port.out = &to_host_;
    board_->port.turns = &turns_;
    board_->identify(identity, status);
    host_->port.in = &to_host_;
    host_->port.out = &to_board_;
    host_->port.turns = &turns_;
    thread_ = std::thread([this] {
      if (turns_.wait_for_turn()) run_board();
    });
    turns_.wait_for_board();
  }
  void TearDown() override {
    turns_.end();
    if (thread_.joinable()) thread_.join();
  }
  void set_faults(const Faults& faults, unsigned seed) {
    to_board_.faults = to_host_.faults = faults;
    to_board_.random.seed(seed);
    to_host_.random.seed(seed + 1000);
  }

  /// The loop of a board: commands, then messages.
  void run_board() {
    while (board_->wait_for_host()) {
      ++sessions_;
      std::uint32_t sum = 0;
      std::uint8_t command = 0;
      while (board_->get(command)) {
        if (command == static_cast<std::uint8_t>(Command::step)) {
          std::uint8_t late = 0;
          if (!board_->get(late)) break;
          Array<std::uint32_t, 20> values{};  // longer than a frame
          bool flag = false;
          if (!board_->get(values) || !board_->get(flag)) break;
          for (const std::uint32_t value : values) sum += value;
          board_->put(sum);
          board_->put(flag);
          board_->put(values);
        } else if (command == static_cast<std::uint8_t>(Command::reset)) {
          Episode episode;
          if (!episode.get(*board_)) break;
          sum = episode.key.episode;
        } else {
          Report{100, board_->damaged()}.put(*board_);
          put_count(*board_, "resets", 7);
          put_count(*board_, "a longer name than a frame has room for", 1ULL << 40U);
          end_counts(*board_);
        }
      }
    }
  }
  /// Steps until one fails; how many went well, and all of these were right.
  int run_host(int steps) {
    std::uint32_t sum = 5;
    host_->begin_episode({{1, 2, 5}, 0});
    for (int step = 0; step < steps; ++step) {
      Array<std::uint32_t, 20> values{};
      for (std::uint32_t i = 0; i < 20; ++i) {
        values[i] = i * static_cast<std::uint32_t>(step);
        sum += values[i];
      }
      const bool flag = step % 3 == 0;
      host_->begin_step();
      host_->put(values);
      host_->put(flag);
      std::uint32_t found = 0;
      bool flag_found = false;
      Array<std::uint32_t, 20> echo{};
      if (!host_->get(found) || !host_->get(flag_found) || !host_->get(echo)) return step;
      EXPECT_EQ(found, sum);
      EXPECT_EQ(flag_found, flag);
      EXPECT_EQ(echo, values);
    }
    return steps;
  }

  Wire to_board_, to_host_;
  Turns turns_;
  std::unique_ptr<HostEnd> host_ = std::make_unique<HostEnd>();
  std::unique_ptr<BoardEnd> board_ = std::make_unique<BoardEnd>();
  std::thread thread_;
  int sessions_ = 0;
};

// Messages in flight, half written or half read belong to the previous session.
TEST_F(Line, BeginsAnewInTheMiddleOfAnExchange) {
  start();
  for (std::uint32_t session = 1; session <= 20; ++session) {
    ASSERT_TRUE(host_->open(kIdentity, session));
    EXPECT_EQ(run_host(5), 5);
    host_->begin_step();
    for (std::uint32_t i = 0; i < session; ++i) host_->put(i);
    if (session % 3 == 0) host_->submit();
  }
  EXPECT_EQ(sessions_, 20);
}

TEST_F(Line, CarriesMessagesLongerThanItsFrames) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  EXPECT_EQ(run_host(50), 50);
  Report report;
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  ASSERT_TRUE(host_->finish(
      report, [&](const char* name, std::uint64_t count) { counts.emplace_back(name, count); }));
  EXPECT_EQ(report.stack_bytes, 100U);
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_EQ(counts[0].first, "resets");
  EXPECT_EQ(counts[0].second, 7U);
  EXPECT_EQ(counts[1].first, "a longer name than a frame has room for");
  EXPECT_EQ(counts[1].second, 1ULL << 40U);
  EXPECT_EQ(host_->statistics().repeated, 0U);
  EXPECT_EQ(host_->statistics().ignored, 0U);
}

TEST_F(Line, RepeatsUntilItIsRight) {
  start();
  for (unsigned seed = 1; seed <= 20; ++seed) {
    set_faults({20, 20, 20, 20, 20}, seed);
    host_->set_time_limit(600'000'000'000);
    ASSERT_TRUE(host_->open(kIdentity, seed)) << seed;
    EXPECT_EQ(run_host(50), 50) << seed;
    Report report;
    EXPECT_TRUE(host_->finish(report, [](const char*, std::uint64_t) {}));
  }
  EXPECT_EQ(sessions_, 20);
  EXPECT_GT(host_->statistics().repeated, 1000U);
  EXPECT_GT(host_->statistics().ignored, 1000U);
}

TEST_F(Line, TenThousandHostileFramesEachWayChangeNothing) {
  start();
  to_board_.to_board = true;
  to_host_.random.seed(2);
  ASSERT_TRUE(host_->open(kIdentity, 1));
  to_board_.hostile = to_host_.hostile = 20;
  int steps = 0;
  while (steps < 5000 && std::min(to_board_.hostile_frames, to_host_.hostile_frames) < 10'000) {
    ASSERT_EQ(run_host(10), 10) << steps;  // and all that came was right
    steps += 10;
  }
  EXPECT_GE(to_board_.hostile_frames, 10'000U);
  EXPECT_GE(to_host_.hostile_frames, 10'000U);
  EXPECT_EQ(sessions_, 1);
  EXPECT_GT(board_->damaged(), 1000U);
  to_board_.hostile = to_host_.hostile = 0;
  Report report;
  EXPECT_TRUE(host_->finish(report, [](const char*, std::uint64_t) {}));
}

TEST_F(Line, GivesUpWhenNothingComes) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  EXPECT_EQ(run_host(3), 3);
  set_faults({100, 0, 0, 0, 0}, 1);
  const std::uint64_t before = host_->port.now;
  EXPECT_EQ(run_host(3), 0);
  EXPECT_EQ(host_->problem(), Problem::no_answer);
  EXPECT_EQ(host_->port.now - before, 5'000'000'000U);
}

TEST_F(Line, TellsOnceInAnExchangeThatTheBoardIsSilent) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  int times = 0;
  host_->on_silence(
      10'000'000, [](void* context) { ++*static_cast<int*>(context); }, &times);
  EXPECT_EQ(run_host(3), 3);
  EXPECT_EQ(times, 0);
  set_faults({100, 0, 0, 0, 0}, 1);
  const std::uint64_t before = host_->port.now;
  EXPECT_EQ(run_host(3), 0);
  EXPECT_EQ(times, 1);
  EXPECT_EQ(host_->port.now - before, 5'000'000'000U) << "it waits on";
}

TEST_F(Line, ReportsNoSilenceAfterTheEnd) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  int times = 0;
  host_->on_silence(
      10'000'000, [](void* context) { ++*static_cast<int*>(context); }, &times);
  EXPECT_EQ(run_host(3), 3);
  host_->on_silence(0, nullptr, nullptr);
  set_faults({100, 0, 0, 0, 0}, 1);
  Report report;
  EXPECT_FALSE(host_->finish(report, [](const char*, std::uint64_t) {}));
  EXPECT_EQ(times, 0);
}

TEST(Number, OfAnExchangeIsNeverThatOfNone) {
  EXPECT_EQ(next_number(0), 1U);
  EXPECT_EQ(next_number(UINT32_MAX), 1U);
}

TEST_F(Line, SaysWhenItIsClosed) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  EXPECT_EQ(run_host(3), 3);
  host_->port.unplugged = true;
  EXPECT_EQ(run_host(3), 0);
  EXPECT_EQ(host_->problem(), Problem::closed);
}

TEST_F(Line, ANewHostStartsTheBoardAnew) {
  start();
  ASSERT_TRUE(host_->open(kIdentity, 1));
  EXPECT_EQ(run_host(3), 3);
  host_->begin_step();  // and in the middle of a step it is gone
  ASSERT_TRUE(host_->open(kIdentity, 2));
  EXPECT_EQ(run_host(3), 3);
  EXPECT_EQ(sessions_, 2);
}

TEST_F(Line, RefusesAnotherGraph) {
  start({0x1235, 1});
  EXPECT_FALSE(host_->open(kIdentity, 1));
  EXPECT_EQ(host_->problem(), Problem::other_graph);
  EXPECT_EQ(host_->board().graph, 0x1235U);
  EXPECT_EQ(sessions_, 0);
}

TEST_F(Line, RefusesAnotherRuntime) {
  start({0x1234, 2});
  EXPECT_FALSE(host_->open(kIdentity, 1));
  EXPECT_EQ(host_->problem(), Problem::other_runtime);
}

TEST_F(Line, RefusesABoardThatDoesNotWork) {
  start(kIdentity, 1);
  EXPECT_FALSE(host_->open(kIdentity, 1));
  EXPECT_EQ(host_->problem(), Problem::refused);
  EXPECT_EQ(sessions_, 0);
}

TEST_F(Line, ALinkThatIsOverStaysSo) {
  start();
  EXPECT_EQ(run_host(3), 0);  // never opened
  EXPECT_EQ(host_->problem(), Problem::closed);
}

}  // namespace
}  // namespace eagerx::link

// `sync: false` in a generated program, on a clock that stands still unless the test moves it.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "by_the_clock/graph.hpp"

namespace async_test {
namespace {

namespace graph = graphs::by_the_clock;
using Program = graph::Program<>;
using eagerx::Seq;

constexpr std::int64_t kMs = 1'000'000;

class ByTheClock : public ::testing::Test {
 protected:
  void SetUp() override { begin(0, 0); }

  /// An episode in which the slot of tick `late` (10 ms each) begins `late_ms` too late.
  void begin(Seq late, std::int64_t late_ms) {
    Clock::now_ns = 1000 * kMs;
    Clock::late_tick = late;
    Clock::late_ns = late_ms * kMs;
    rows.clear();
    add(program.reset({}));
  }
  void step(int times) {
    for (int i = 0; i < times; ++i) add(program.step({}));
  }
  std::uint64_t count(const char* wanted) const {
    std::uint64_t result = 0;
    program.for_each_count([&](const char* name, std::uint64_t value) {
      if (std::strcmp(name, wanted) == 0) result = value;
    });
    return result;
  }

  struct Row {
    std::int64_t now, delayed, copied;
    std::vector<std::int64_t> all, fresh;
  };
  std::vector<Row> rows;  // observations

 private:
  void add(const graph::Observation& seen) {
    Row row{seen.now.back(), seen.delayed.back(), seen.copied.back(), {}, {}};
    for (std::uint32_t i = 0; i < seen.all.size(); ++i) row.all.push_back(seen.all[i]);
    for (std::uint32_t i = 0; i < seen.fresh.size(); ++i) row.fresh.push_back(seen.fresh[i]);
    rows.push_back(row);
  }
  Program program{};
};

using Numbers = std::vector<std::int64_t>;

// The first observation is the first at which every window has a message: that of 50 ms.
TEST_F(ByTheClock, AnEpisodeBeginsWhenEverythingHasArrived) {
  EXPECT_EQ(rows[0].now, 5);
  EXPECT_EQ(rows[0].delayed, 2) << "sent at 20 ms, 30 ms ago";
  EXPECT_EQ(rows[0].copied, 2) << "25 ms ago would be between two";
  EXPECT_EQ(rows[0].all, (Numbers{1, 2, 3, 4, 5})) << "message 0 was of the tick at 0 ms";
  // `late` cannot run at 0, 10 and 20 ms; `sink` has no action at 0, 10, 20, 30 and 40 ms.
  EXPECT_EQ(count("callbacks without a message"), 3U + 5U);
}

TEST_F(ByTheClock, OnTimeItIsAsCounted) {
  step(20);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const auto tick = static_cast<std::int64_t>(5 * (k + 1));
    EXPECT_EQ(rows[k].now, tick);
    EXPECT_EQ(rows[k].delayed, tick - 3);
    EXPECT_EQ(rows[k].copied, tick - 3);
    EXPECT_EQ(rows[k].all, (Numbers{tick - 4, tick - 3, tick - 2, tick - 1, tick}));
    EXPECT_EQ(rows[k].fresh, (Numbers{1, 1, 1, 1, 1}));
  }
  EXPECT_EQ(count("messages overtaken"), 0U);
  EXPECT_EQ(count("episodes without an observation"), 0U);
}

// The slot of 120 ms begins at 127 ms: what it sends has not arrived 30 ms later by 150 ms.
TEST_F(ByTheClock, ALateSlotMakesItsMessageMiss) {
  begin(12, 7);
  step(4);
  EXPECT_EQ(rows[2].now, 15);
  EXPECT_EQ(rows[2].delayed, 11) << "counted, it would be 12";
  EXPECT_EQ(rows[2].copied, 11) << "25 ms before 150 ms is 125 ms";
  EXPECT_EQ(rows[2].fresh, (Numbers{1, 2, 0, 1, 0})) << "at 110, 127, 130, 140 and 150 ms";
  EXPECT_EQ(rows[3].delayed, 17) << "it has caught up";
  EXPECT_EQ(rows[3].fresh, (Numbers{2, 1, 1, 1, 1})) << "12 and 13 arrive at once";
}

// The slot of 120 ms begins at 147 ms, those of 130 and 140 ms follow at once.
TEST_F(ByTheClock, MessagesOfSlotsThatCatchUpArriveTogether) {
  begin(12, 27);
  step(4);
  EXPECT_EQ(rows[2].now, 15) << "no tick is dropped";
  EXPECT_EQ(rows[2].fresh, (Numbers{1, 3, 0, 0, 0})) << "at 110, 147, 147, 147 and 150 ms";
  EXPECT_EQ(rows[3].fresh, (Numbers{0, 0, 4, 1, 1})) << "12, 13 and 14 of 147 ms, 15";
  EXPECT_EQ(rows[3].all, (Numbers{16, 17, 18, 19, 20}));
}

// A machine that stands still for a second: the ring is as large as late slots need, no larger.
TEST_F(ByTheClock, WhatLeavesItsRingBeforeItArrivesIsCounted) {
  begin(12, 1000);
  step(30);
  EXPECT_GT(count("messages overtaken"), 0U);
  EXPECT_EQ(rows.back().now, 155) << "nothing is dropped that needs no delay";
  EXPECT_EQ(rows.back().delayed, 152) << "and afterwards all is well";
}

TEST_F(ByTheClock, EpisodesDoNotKnowOfEachOther) {
  begin(12, 7);
  step(10);
  begin(0, 0);
  EXPECT_EQ(rows[0].now, 5);
  EXPECT_EQ(rows[0].all, (Numbers{1, 2, 3, 4, 5}));
}

/// A request to end the run from the start.
struct Interrupted : eagerx::NoHooks {
  static bool is_interrupted() { return true; }
};

TEST(Interrupt, EndsTheWaitForAnObservation) {
  Clock::now_ns = 0;
  Clock::late_tick = 0;
  graph::Program<Interrupted> program{};
  program.reset({});
  EXPECT_LT(Clock::now_ns, 50 * kMs) << "as soon as it was seen";
  program.for_each_count([](const char* name, std::uint64_t value) {
    if (std::strcmp(name, "episodes without an observation") == 0) {
      EXPECT_EQ(value, 0U);
    }
  });
}

}  // namespace
}  // namespace async_test

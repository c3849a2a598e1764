// eagerx/link/pipeline.hpp: a hub that continues while messages are in flight reads what it would
// have read, and its trace has the order that it would have had, on any line.
#include <gtest/gtest.h>

#include <cstdint>
#include <eagerx/link/pipeline.hpp>
#include <memory>
#include <thread>
#include <tuple>
#include <vector>

#include "tests/unit/runtime/link_line.hpp"

namespace eagerx::link {
namespace {

constexpr std::size_t kDepth = 4, kBytes = 64;
using HubEnd = HostLink<HostPort, kBytes, kBytes, kDepth>;
using PartEnd = BoardLink<BoardPort, kBytes, kBytes, kDepth>;
constexpr PartIndex<0> kPart;
constexpr std::uint32_t kSent = 0, kAnswered = 1;

using Calls = std::vector<std::tuple<std::uint32_t, Seq, std::uint32_t>>;
struct KeepingHooks {
  Calls lines;
  void on_message(std::uint32_t channel, Seq seq, std::uint32_t& message) {
    lines.emplace_back(channel, seq, message);
  }
};

/// Sends a number a step, and reads the sum of all `delay` steps after it was sent.
template <std::size_t TraceBytes>
class Hub {
 public:
  KeepingHooks hooks;
  Star<HubEnd> star;
  Star<HubEnd>& link() { return star; }

  /// Steps until one fails.
  Seq run(Seq steps, Seq delay) {
    taken_ = 0;
    star.begin_episode({{1, 2, 5}, 0});
    for (Seq n = 0; n < steps; ++n) {
      if (!ask(n)) return n;
      most_on_way = std::max(most_on_way, n + 1 - taken_);
      const Seq count = pipeline_.need(*this, kPart, taken_, n < delay ? 1 : n - delay + 1);
      if (!star.ok()) return n;
      EXPECT_EQ(ring_[(count - 1) % kRing], sum_of(count - 1)) << n;
    }
    return pipeline_.drain(*this) ? steps : 0;
  }
  /// The same with a part that receives other frames in between.
  void run_held(Seq from, Seq steps) {
    EXPECT_TRUE(pipeline_.hold(*this));
    EXPECT_EQ(taken_, from);
    for (Seq n = from; n < from + steps; ++n) {
      ask(n);
      EXPECT_EQ(taken_, n + 1);
    }
    pipeline_.resume();
    ask(from + steps);
    EXPECT_EQ(taken_, from + steps);
    EXPECT_TRUE(pipeline_.drain(*this));
  }
  /// The calls that the trace must receive.
  static Calls expected(Seq steps) {
    Calls lines;
    for (Seq n = 0; n < steps; ++n) {
      lines.emplace_back(kSent, n, static_cast<std::uint32_t>(n * n));
      lines.emplace_back(kAnswered, n, sum_of(n));
    }
    return lines;
  }
  Seq most_on_way = 0;

 private:
  static constexpr std::size_t kRing = 64;
  bool ask(Seq n) {
    star.begin_step();
    auto value = static_cast<std::uint32_t>(n * n);
    pipeline_.tell(*this, kSent, n, value);
    star.put(kPart, value);
    return pipeline_.request(*this, kPart, &Hub::take, n, Awaited<std::uint32_t>{kAnswered});
  }
  static std::uint32_t sum_of(Seq n) {
    std::uint32_t sum = 0;
    for (Seq i = 0; i <= n; ++i) sum += static_cast<std::uint32_t>(i * i);
    return sum;
  }
  bool take(Seq n, Record* record) {
    std::uint32_t& place = ring_[n % kRing];
    if (!star.get(kPart, kAnswered, place)) return false;
    pipeline_.came(*this, record, kAnswered, n, place);
    return ++taken_, true;
  }

  std::uint32_t ring_[kRing] = {};
  Seq taken_ = 0;
  template <class, class, std::size_t, std::size_t, std::size_t>
  friend class Pipeline;
  Pipeline<Hub, KeepingHooks, 1, 16, TraceBytes> pipeline_{};
};

class LinkPipeline : public ::testing::Test {
 protected:
  void TearDown() override {
    turns_.end();
    if (thread_.joinable()) thread_.join();
  }
  template <class AnyHub>
  void connect(AnyHub& hub, const Faults& faults = {}, unsigned seed = 1) {
    to_board_.faults = to_host_.faults = faults;
    to_board_.random.seed(seed);
    to_host_.random.seed(seed + 1000);
    HubEnd& end = hub.star.template link<0>();
    end.port.in = &to_host_;
    end.port.out = &to_board_;
    end.port.turns = &turns_;
    end.set_time_limit(600'000'000'000);
    hub.star.set_pipelined(true);
    if (!thread_.joinable()) {
      part_->port.in = &to_board_;
      part_->port.out = &to_host_;
      part_->port.turns = &turns_;
      part_->identify(kIdentity, 0);
      thread_ = std::thread([this] {
        if (turns_.wait_for_turn()) run_part();
      });
      turns_.wait_for_board();
    }
    ASSERT_TRUE(end.open(kIdentity, ++session_));
  }
  void run_part() {
    while (part_->wait_for_host()) {
      std::uint32_t sum = 0;
      std::uint8_t command = 0, late = 0;
      while (part_->get(command)) {
        Episode episode;
        std::uint32_t value = 0;
        if (command == static_cast<std::uint8_t>(Command::reset)) {
          if (!episode.get(*part_)) break;
        } else {
          if (!part_->get(late) || !part_->get(value)) break;
          sum += value;
          part_->put(sum);
        }
      }
    }
  }

  Wire to_board_, to_host_;
  Turns turns_;
  std::unique_ptr<PartEnd> part_ = std::make_unique<PartEnd>();
  std::thread thread_;
  std::uint32_t session_ = 0;
};

constexpr std::size_t kEnough = 4096;

TEST_F(LinkPipeline, ExchangesAreOnTheirWayWhileADelayGivesTime) {
  auto hub = std::make_unique<Hub<kEnough>>();
  connect(*hub);
  EXPECT_EQ(hub->run(200, 3), 200U);
  EXPECT_EQ(hub->most_on_way, 4U);
  EXPECT_EQ(hub->hooks.lines, Hub<kEnough>::expected(200));
  EXPECT_EQ(hub->star.link<0>().statistics().exchanges, 200U);
  EXPECT_EQ(hub->star.link<0>().statistics().repeated, 0U);
}

TEST_F(LinkPipeline, NeverMoreThanTheLinkHasFramesFor) {
  auto hub = std::make_unique<Hub<kEnough>>();
  connect(*hub);
  EXPECT_EQ(hub->run(200, 30), 200U);
  EXPECT_EQ(hub->most_on_way, kDepth);
  EXPECT_EQ(hub->hooks.lines, Hub<kEnough>::expected(200));
}

TEST_F(LinkPipeline, WithoutADelayEachIsWaitedFor) {
  auto hub = std::make_unique<Hub<kEnough>>();
  connect(*hub);
  EXPECT_EQ(hub->run(50, 0), 50U);
  EXPECT_EQ(hub->most_on_way, 1U);
}

TEST_F(LinkPipeline, InLockstepNothingIsOnItsWay) {
  auto hub = std::make_unique<Hub<kEnough>>();
  connect(*hub);
  hub->star.set_pipelined(false);
  EXPECT_EQ(hub->run(50, 3), 50U);
  EXPECT_EQ(hub->most_on_way, 0U);
  EXPECT_EQ(hub->hooks.lines, Hub<kEnough>::expected(50));
}

TEST_F(LinkPipeline, WhatIsHeldIsAskedForAndTaken) {
  auto hub = std::make_unique<Hub<kEnough>>();
  connect(*hub);
  EXPECT_EQ(hub->run(3, 3), 3U);
  hub->run_held(3, 20);
  EXPECT_EQ(hub->hooks.lines, Hub<kEnough>::expected(24));
}

TEST(LinkLate, TheFirstComesAtOnceAndTheOthersInOrder) {
  for (const Seq lag : {0U, 1U, 5U}) {
    Seq next = 0;
    for (Seq n = 0; n < 20; ++n) {
      if (!comes_late(n, lag)) continue;
      EXPECT_EQ(sent_before(n, lag), next++) << n;
    }
    EXPECT_EQ(next, 20U - lag);
  }
}

TEST_F(LinkPipeline, ATraceWithoutRoomWaits) {
  // Two records fit, of four that would wait; and the ring goes around where none ends.
  for (const Seq steps : {1U, 2U, 3U, 100U}) {
    auto small = std::make_unique<Hub<112>>();
    connect(*small);
    EXPECT_EQ(small->run(steps, 3), steps);
    EXPECT_EQ(small->hooks.lines, Hub<112>::expected(steps));
    auto odd = std::make_unique<Hub<368>>();
    connect(*odd);
    EXPECT_EQ(odd->run(steps, 3), steps);
    EXPECT_EQ(odd->hooks.lines, Hub<368>::expected(steps));
  }
}

TEST_F(LinkPipeline, ABadLineChangesNothing) {
  std::uint64_t repeated = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto hub = std::make_unique<Hub<kEnough>>();
    connect(*hub, {20, 20, 20, 20, 20}, seed);
    EXPECT_EQ(hub->run(60, 3), 60U) << seed;
    EXPECT_EQ(hub->hooks.lines, Hub<kEnough>::expected(60)) << seed;
    EXPECT_GT(hub->most_on_way, 1U);
    repeated += hub->star.link<0>().statistics().repeated;
  }
  EXPECT_GT(repeated, 500U);
}

TEST_F(LinkPipeline, NothingBehindAMissingFrameIsReported) {
  auto hub = std::make_unique<Hub<kEnough>>();
  connect(*hub);
  EXPECT_EQ(hub->run(50, 3), 50U);
  to_host_.faults = {100, 0, 0, 0, 0};
  EXPECT_LT(hub->run(50, 3), 50U);
  EXPECT_EQ(hub->star.link<0>().problem(), Problem::no_answer);
  Calls lines = Hub<kEnough>::expected(50);
  lines.emplace_back(kSent, 0, 0);  // before the first that did not come
  EXPECT_EQ(hub->hooks.lines, lines);
}

}  // namespace
}  // namespace eagerx::link

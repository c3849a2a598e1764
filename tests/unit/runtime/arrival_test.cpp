// eagerx/arrival.hpp: inputs that go by the clock.
#include <gtest/gtest.h>

#include <eagerx/arrival.hpp>

namespace eagerx {
namespace {

TEST(ArrivalCursor, TakesWhatIsAsOldAsTheDelay) {
  Sent<8> source;
  Arrivals arrivals;
  ArrivalCursor<8, 2> input;
  source.reset();
  input.reset(30);
  EXPECT_EQ(input.take(source, 0, arrivals), 0U) << "nothing was sent";
  source.add(100);
  EXPECT_EQ(input.take(source, 129, arrivals), 0U);
  EXPECT_EQ(input.take(source, 130, arrivals), 1U);
  source.add(110);
  source.add(150);
  EXPECT_EQ(input.take(source, 145, arrivals), 2U);
  EXPECT_EQ(input.take(source, 1000, arrivals), 3U);
  EXPECT_EQ(arrivals.overtaken, 0U);
  input.reset(0);
  EXPECT_EQ(input.take(source, 150, arrivals), 3U) << "at once";
}

TEST(ArrivalCursor, NewMessagesOfWindowZero) {
  Sent<8> source;
  Arrivals arrivals;
  ArrivalCursor<8, 3> input;
  source.reset();
  input.reset(10);
  source.add(0);
  source.add(1);
  const Received first = input.take_new(source, 10, arrivals);
  EXPECT_EQ(first.end, 1U);
  EXPECT_EQ(first.held, 1U);
  const Received none = input.take_new(source, 10, arrivals);
  EXPECT_EQ(none.end, 1U);
  EXPECT_EQ(none.held, 0U);
  for (int i = 0; i < 3; ++i) source.add(2);
  const Received most = input.take_new(source, 100, arrivals);
  EXPECT_EQ(most.end, 5U);
  EXPECT_EQ(most.held, 3U) << "the newest";
  EXPECT_EQ(arrivals.overtaken, 1U);
}

TEST(ArrivalCursor, AMessageIsOvertakenOnce) {
  Sent<8> source;
  Arrivals arrivals;
  ArrivalCursor<8, 3> input;
  source.reset();
  input.reset(10);
  for (int i = 0; i < 20; ++i) source.add(0);
  const Received soon = input.take_new(source, 5, arrivals);
  EXPECT_EQ(soon.end, 16U) << "four may be on their way";
  EXPECT_EQ(soon.held, 3U);
  EXPECT_EQ(arrivals.overtaken, 16U);
  for (int i = 0; i < 20; ++i) source.add(20);
  const Received late = input.take_new(source, 100, arrivals);
  EXPECT_EQ(late.end, 40U);
  EXPECT_EQ(late.held, 3U);
  EXPECT_EQ(arrivals.overtaken, 16U + 24U - 3U) << "all but those that a window held";
}

// Whatever is sent and however late it is looked at, a window's messages are all still in the ring.
TEST(ArrivalCursor, NeverReadsWhatWasOverwritten) {
  constexpr Seq kCapacity = 8;
  constexpr Seq kWindow = 3;
  for (int burst = 0; burst < 40; ++burst) {
    Sent<kCapacity> source;
    Arrivals arrivals;
    ArrivalCursor<kCapacity, kWindow> input;
    source.reset();
    input.reset(1'000'000);
    Seq before = 0;
    for (int round = 0; round < 5; ++round) {
      for (int i = 0; i < burst; ++i) source.add(round);
      const Seq end = input.take(source, round, arrivals);
      EXPECT_GE(end, before);
      EXPECT_LE(end, source.count());
      const Seq oldest = end < kWindow ? 0 : end - kWindow;
      // The sender may write one more message while the window is read.
      EXPECT_LE(source.count() + 1 - oldest, end == 0 ? source.count() + 1 : kCapacity);
      EXPECT_EQ(arrivals.overtaken, end);
      before = end;
    }
  }
}

}  // namespace
}  // namespace eagerx

// Datagrams and their order; what a graph expects of a stream.
#include "generator/tools/monitor/stream.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "generator/tools/monitor/datagram.hpp"
#include "generator/tools/monitor/step_order.hpp"

namespace eagerx::gen {
namespace {

const std::string kBegin = R"({"timestamp":0.5,"episode":1,"step":3,"graph":"0x00000000000000ff")";

TEST(Datagram, HasTheMessagesOfAStep) {
  const auto datagram =
      read_datagram(kBegin + R"(,"a/x":1.5,"a/b":[1,null,-2e3],"a/flag":true,"a/none":null})");
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->time_s, 0.5);
  EXPECT_EQ(datagram->episode, 1U);
  EXPECT_EQ(datagram->step, 3U);
  EXPECT_EQ(datagram->graph_hash, 0xffU);
  ASSERT_EQ(datagram->messages.size(), 4U);
  EXPECT_EQ(datagram->messages[0].channel, "a/x");
  EXPECT_EQ(datagram->messages[0].values, std::vector<double>{1.5});
  EXPECT_EQ(datagram->messages[1].values[2], -2000.0);
  EXPECT_TRUE(std::isnan(datagram->messages[1].values[1]));
  EXPECT_EQ(datagram->messages[2].values, std::vector<double>{1.0});
  EXPECT_TRUE(std::isnan(datagram->messages[3].values[0]));
}

TEST(Datagram, NeedsTimeEpisodeAndStep) {
  EXPECT_TRUE(read_datagram(R"({"timestamp":0,"episode":0,"step":0})"));
  EXPECT_FALSE(read_datagram(R"({"episode":0,"step":0})"));
  EXPECT_FALSE(read_datagram(R"({"timestamp":0,"step":0})"));
  EXPECT_FALSE(read_datagram(R"({"timestamp":0,"episode":0})"));
}

TEST(Datagram, OthersAreNone) {
  for (const char* const more :
       {R"(,"a":{}})", R"(,"a":"text"})", R"(,"a":[]})", R"(,"a":[[1]]})", R"(,"a":[1,"x"]})",
        R"(,"a,b":1})", R"(,"":1})", R"(,"a\u0007":1})", R"(,"a":1,"a":2})", R"(,"a":1)",
        R"(,"a":1e999})"})
    EXPECT_FALSE(read_datagram(kBegin + more)) << more;
  for (const char* const text :
       {"", "x", "[]", "1", "null", R"({"timestamp":-1,"episode":0,"step":0})",
        R"({"timestamp":1e300,"episode":0,"step":0})", R"({"timestamp":0,"episode":-1,"step":0})",
        R"({"timestamp":0,"episode":4294967296,"step":0})",
        R"({"timestamp":0,"episode":0,"step":0.5})",
        R"({"timestamp":0,"episode":0,"step":0,"graph":"0xff"})",
        R"({"timestamp":0,"episode":0,"step":0,"graph":5})"})
    EXPECT_FALSE(read_datagram(text)) << text;
  EXPECT_FALSE(read_datagram(std::string(60'000, '[')));
}

TEST(Datagram, HasABound) {
  std::string text = kBegin;
  for (std::size_t i = 0; i < kMostStreamChannels + 5; ++i)
    text += ",\"c" + std::to_string(i) + "\":1";
  auto datagram = read_datagram(text + "}");
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->messages.size(), kMostStreamChannels);
  EXPECT_EQ(datagram->crowded_out, 5U);
  text = kBegin + ",\"long\":[0";
  for (std::size_t i = 1; i < kMostStreamElements + 7; ++i) text += ",1";
  datagram = read_datagram(text + "]}");
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->messages.front().values.size(), kMostStreamElements);
  EXPECT_EQ(datagram->messages.front().elements, kMostStreamElements + 7);
  EXPECT_EQ(datagram->crowded_out, 7U);
}

class Order : public testing::Test {
 protected:
  using Place = StepOrder::Place;
  Place place(std::uint32_t episode, std::uint64_t step, double time_s, std::int64_t now_ms,
              std::uint64_t hash = 1) {
    Datagram datagram;
    datagram.episode = episode;
    datagram.step = step;
    datagram.time_s = time_s;
    datagram.graph_hash = hash;
    return order_.place(datagram, now_ms * 1'000'000);
  }
  StepOrder order_;
};

TEST_F(Order, StepsFollow) {
  EXPECT_EQ(place(0, 7, 0.7, 0), Place::first);
  EXPECT_EQ(place(0, 8, 0.8, 100), Place::next);
  EXPECT_EQ(place(0, 8, 0.8, 101), Place::same);
  EXPECT_EQ(place(0, 7, 0.7, 102), Place::late);
  EXPECT_EQ(place(1, 0, 0.9, 200), Place::next);
  EXPECT_EQ(order_.lost(), 0U);
}

TEST_F(Order, CountsWhatIsMissing) {
  place(0, 0, 0.0, 0);
  place(0, 3, 0.3, 100);  // every third is published
  EXPECT_EQ(order_.lost(), 0U);
  place(0, 12, 1.2, 200);
  EXPECT_EQ(order_.lost(), 2U);
  place(0, 15, 1.5, 300);
  EXPECT_EQ(order_.lost(), 0U);
}

TEST_F(Order, AnotherRunBeginsWithItsReset) {
  place(0, 0, 0.0, 0);
  place(0, 50, 5.0, 100);
  EXPECT_EQ(place(0, 0, 0.0, 200), Place::first);
  EXPECT_EQ(place(0, 1, 0.1, 300), Place::next);
}

TEST_F(Order, AnotherRunMayBeSeenAfterASilence) {
  place(0, 50, 5.0, 0);
  EXPECT_EQ(place(0, 20, 2.0, 1'500), Place::first);
}

TEST_F(Order, AnotherGraphDoesNotComeBetween) {
  place(0, 5, 0.5, 0, 1);
  EXPECT_EQ(place(0, 6, 0.6, 100, 2), Place::foreign);
  EXPECT_EQ(place(0, 6, 0.6, 200, 1), Place::next);
  EXPECT_EQ(place(0, 9, 0.9, 1'500, 2), Place::first);
}

}  // namespace
}  // namespace eagerx::gen

#include <gtest/gtest.h>

#include <atomic>
#include <runtime/host/dds/topics.hpp>
#include <string>
#include <targets/linux-sim/dds/graph_of.hpp>
#include <targets/linux-sim/publish/destination.hpp>
#include <targets/linux-sim/publish/ring.hpp>
#include <thread>

namespace eagerx::linux_sim {
namespace {

constexpr std::size_t kLongest = 5;

std::size_t words_of(std::uint64_t n) {
  return 1 + n % kLongest;
}
bool put(PublishRing& ring, std::uint64_t n) {
  const std::size_t words = words_of(n);
  std::uint64_t* const at = ring.begin(words);
  if (at == nullptr) return false;
  for (std::size_t i = 0; i < words; ++i) at[i] = n;
  ring.commit(words);
  return true;
}
/// Whether record `n` is the oldest, and whole; takes it.
bool take(PublishRing& ring, std::uint64_t n) {
  const std::uint64_t* const at = ring.front();
  if (at == nullptr) return false;
  for (std::size_t i = 0; i < words_of(n); ++i)
    if (at[i] != n) return false;
  ring.pop(words_of(n));
  return true;
}

TEST(PublishRing, KeepsWhatFitsAndRefusesTheRest) {
  PublishRing ring(16, kLongest);
  ASSERT_EQ(ring.front(), nullptr);
  std::uint64_t count = 0;
  while (put(ring, count)) ++count;
  EXPECT_EQ(count, 6U);  // 1 + 2 + 3 + 4 + 5 + 1 words
  for (std::uint64_t n = 0; n < count; ++n) EXPECT_TRUE(take(ring, n));
  EXPECT_EQ(ring.front(), nullptr);
  EXPECT_TRUE(put(ring, count));
}

TEST(PublishRing, RecordsLieInOnePieceAtItsEndToo) {
  PublishRing ring(16, kLongest);
  for (std::uint64_t n = 0; n < 1'000; ++n) {
    ASSERT_TRUE(put(ring, n));
    ASSERT_TRUE(take(ring, n));
  }
}

TEST(PublishRing, TwoThreadsSeeRecordsWholeAndInOrder) {
  constexpr std::uint64_t kCount = 200'000;
  PublishRing ring(64, kLongest);
  std::atomic<bool> stopped = false;
  std::thread writer([&] {
    for (std::uint64_t n = 0; n < kCount && !stopped;) {
      if (put(ring, n)) {
        ++n;
      } else {
        std::this_thread::yield();
      }
    }
  });
  bool good = true;
  for (std::uint64_t n = 0; n < kCount && good; ++n) {
    while (ring.front() == nullptr) std::this_thread::yield();
    good = take(ring, n);
  }
  stopped = true;
  writer.join();
  EXPECT_TRUE(good);
}

TEST(Destination, IsReadStrictly) {
  Destination to;
  ASSERT_TRUE(parse_destination("udp:192.168.0.7:9870", to));
  EXPECT_EQ(to.host, "192.168.0.7");
  EXPECT_EQ(to.port, "9870");
  ASSERT_TRUE(parse_destination("teleplot:[::1]:47269", to));
  EXPECT_EQ(to.kind, Destination::Kind::teleplot);
  EXPECT_EQ(to.host, "::1");
  ASSERT_TRUE(parse_destination("mcap:a:b.mcap", to));
  EXPECT_EQ(to.file, "a:b.mcap");
  ASSERT_TRUE(parse_destination("foxglove:8765", to));
  EXPECT_EQ(to.host, "127.0.0.1");
  EXPECT_EQ(to.port, "8765");
  ASSERT_TRUE(parse_destination("foxglove:[::]:8765", to));
  EXPECT_EQ(to.host, "::");
  for (const char* wrong : {"foxglove:", "foxglove::1", "foxglove:0", "foxglove:x", "", "udp",
                            "udp:", "udp:1234", "udp::1234", "udp:a:", "udp:a:0", "udp:a:65536",
                            "udp:a:1x", "udp:::1:80", "mcap:", "mcap:-", "rtp:a:1"})
    EXPECT_FALSE(parse_destination(wrong, to)) << wrong;
}

TEST(Destination, OfDdsIsADomainAndPerhapsAnInterface) {
  Destination to;
  ASSERT_TRUE(parse_destination("dds", to));
  EXPECT_EQ(to.kind, Destination::Kind::dds);
  EXPECT_EQ(to.network.domain, 0U);
  EXPECT_EQ(to.network.interface, "");
  ASSERT_TRUE(parse_destination("dds:232@enp0s31f6.7", to));
  EXPECT_EQ(to.network.domain, 232U);
  EXPECT_EQ(to.network.interface, "enp0s31f6.7");
  ASSERT_TRUE(parse_destination("dds@192.168.0.7", to));
  EXPECT_EQ(to.network.interface, "192.168.0.7");
  for (const char* wrong : {"dds:", "dds:233", "dds:-1", "dds:1x", "dds@", "dds:1@", "dds:1@a b",
                            "dds:1@a\"/>", "dds1", "ddsx", "dds:99999999999"})
    EXPECT_FALSE(parse_destination(wrong, to)) << wrong;
}

TEST(Topics, HaveTheNamesOfEagerx) {
  EXPECT_EQ(dds::topic_of_channel("robot", "smooth/filtered"), "rt/robot/smooth/outputs/filtered");
  EXPECT_EQ(dds::topic_of_channel("robot", "left/theta/observation"),
            "rt/robot/left/theta/outputs/observation");
  EXPECT_EQ(dds::topic_of_environment("robot", "actions", "voltage"),
            "rt/robot/environment/actions/voltage");
}

TEST(Topics, HaveNamesThatRos2Allows) {
  EXPECT_EQ(dds::topic_of_channel("my-robot", "arm[0]/2nd"), "rt/my_robot/arm_0_/outputs/_2nd");
  EXPECT_EQ(dds::problem_of_names({"rt/a/b", "rt/a/c"}), "");
  EXPECT_EQ(dds::problem_of_names({"rt/a/b", "rt/a/c", "rt/a/b"}),
            "error: two topics of ROS 2 would have the name `rt/a/b`\n"
            "help: give one of them another name in the graph");
  EXPECT_NE(dds::problem_of_names({std::string(300, 'a')}), "");
}

/// The form of a channel's messages.
dds::Form form_of(const char* dtype, const char* port, const char* sizes,
                  Publisher publisher = Publisher::engine_node) {
  const Channel channel{"a/b", dtype, 1, 1, 1, publisher, port};
  const ChannelShape shape{0, sizes};
  GraphFacts facts{};
  facts.name = "graph";
  facts.channels = &channel;
  facts.channel_count = 1;
  facts.shapes = &shape;
  facts.shape_count = *sizes == '\0' ? 0 : 1;
  return dds::topics_of(graph_of(facts)).at(0).form;
}

TEST(Topics, HaveATypeWhereTheShapeFits) {
  using dds::Form;
  EXPECT_EQ(form_of("float32", "arm.position", ""), Form::number);
  EXPECT_EQ(form_of("float32", "arm.position", "2"), Form::position);
  EXPECT_EQ(form_of("float64", "arm.velocity", "12"), Form::velocity);
  EXPECT_EQ(form_of("float32", "arm.torque", "1"), Form::effort);
  EXPECT_EQ(form_of("float32", "arm.position", "2", Publisher::node), Form::array);
  EXPECT_EQ(form_of("int32", "arm.position", "2"), Form::array);
  EXPECT_EQ(form_of("float32", "arm.position", "2x3"), Form::array);
  EXPECT_EQ(form_of("float32", "arm.imu", "6"), Form::imu);
  EXPECT_EQ(form_of("float32", "arm.imu", "7"), Form::array);
  EXPECT_EQ(form_of("uint8", "eye.image", "48x64x3", Publisher::node), Form::image);
  EXPECT_EQ(form_of("uint8", "eye.image", "48x64", Publisher::node), Form::image);
  EXPECT_EQ(form_of("uint8", "eye.image", "48x64x2", Publisher::node), Form::array);
  EXPECT_EQ(form_of("float32", "eye.image", "48x64x3", Publisher::node), Form::array);
  EXPECT_STREQ(dds::encoding_of({48, 64, 3}), "rgb8");
  EXPECT_STREQ(dds::encoding_of({48, 64, 4}), "rgba8");
  EXPECT_STREQ(dds::encoding_of({48, 64, 1}), "mono8");
}

}  // namespace
}  // namespace eagerx::linux_sim

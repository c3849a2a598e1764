#include <gtest/gtest.h>

#include <atomic>
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

}  // namespace
}  // namespace eagerx::linux_sim

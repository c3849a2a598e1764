// eagerx/trace.hpp: the hash of a run notices everything that makes a run another one, and nothing
// else.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <eagerx/hooks.hpp>
#include <eagerx/trace.hpp>
#include <limits>
#include <set>

namespace eagerx {
namespace {

template <class... Messages>
std::uint64_t hash_of(const Messages&... messages) {
  HashTrace trace;
  trace.on_episode(0);
  Seq seq = 0;
  (trace.on_message(1, seq++, messages), ...);
  return trace.hash();
}

TEST(CanonicalBits, AreThoseOfTheNumber) {
  EXPECT_EQ(canonical_bits(1.0F), 0x3f800000U);
  EXPECT_EQ(canonical_bits(1.0), 0x3ff0000000000000U);
  EXPECT_EQ(canonical_bits(-0.0F), 0x80000000U);
  EXPECT_EQ(canonical_bits(true), 1U);
  EXPECT_EQ(canonical_bits(std::int8_t{-1}), ~std::uint64_t{0});
  EXPECT_EQ(canonical_bits(std::uint8_t{255}), 255U);
}

// x86 makes negative NaN, ARM positive ones.
TEST(CanonicalBits, AreTheSameForAllNaN) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(canonical_bits(nan), canonical_bits(std::bit_cast<float>(0xffc12345U)));
  EXPECT_EQ(canonical_bits(nan), canonical_bits(std::bit_cast<float>(0x7f800001U)));
  const double wide = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(canonical_bits(wide), canonical_bits(-wide));
  EXPECT_NE(canonical_bits(wide), canonical_bits(std::numeric_limits<double>::infinity()));
}

TEST(HashTrace, RepeatsForTheSameRun) {
  EXPECT_EQ(hash_of(1.0F, 2.0F), hash_of(1.0F, 2.0F));
}

TEST(HashTrace, NoticesValuesAndTheirOrder) {
  const std::set<std::uint64_t> hashes = {hash_of(),
                                          hash_of(0.0F),
                                          hash_of(-0.0F),
                                          hash_of(1.0F),
                                          hash_of(1.0F, 2.0F),
                                          hash_of(2.0F, 1.0F),
                                          hash_of(1.0F, 2.0F, 0.0F),
                                          hash_of(std::nextafterf(1.0F, 2.0F))};
  EXPECT_EQ(hashes.size(), 8U);
}

TEST(HashTrace, NoticesEveryElement) {
  using Matrix = Array<float, 2, 2>;
  const Matrix message = {{1, 2, 3, 4}};
  for (std::size_t i = 0; i < 4; ++i) {
    Matrix other = message;
    other[i] = 5;
    EXPECT_NE(hash_of(other), hash_of(message)) << i;
  }
}

TEST(HashTrace, NoticesChannelSequenceAndEpisode) {
  std::set<std::uint64_t> hashes;
  for (const std::uint32_t episode : {0U, 1U}) {
    for (const std::uint32_t channel : {0U, 1U, 2U}) {
      for (const Seq seq : {Seq{0}, Seq{1}, Seq{1} << 32U}) {
        HashTrace trace;
        trace.on_episode(episode);
        trace.on_message(channel, seq, 1.0);
        hashes.insert(trace.hash());
      }
    }
  }
  EXPECT_EQ(hashes.size(), 18U);
}

TEST(HashTrace, NoticesWhereEpisodesBegin) {
  HashTrace once;
  once.on_episode(0);
  once.on_message(0, 0, 1.0F);
  once.on_message(0, 1, 1.0F);
  HashTrace twice;
  twice.on_episode(0);
  twice.on_message(0, 0, 1.0F);
  twice.on_episode(1);
  twice.on_message(0, 1, 1.0F);
  EXPECT_NE(once.hash(), twice.hash());
}

// A sign that flips in two messages must not cancel.
TEST(HashTrace, PairsOfSignFlipsDoNotCancel) {
  EXPECT_NE(hash_of(1.0, 1.0), hash_of(-1.0, -1.0));
  EXPECT_NE(hash_of(1.0, 1.0, 1.0), hash_of(-1.0, 1.0, -1.0));
}

// The whole program object lives in .bss: it must be all zero before its first reset.
TEST(HashTrace, StartsAsZeroBytes) {
  static constinit HashTrace trace;
  unsigned char bytes[sizeof trace];
  std::memcpy(bytes, &trace, sizeof trace);
  for (const unsigned char byte : bytes) EXPECT_EQ(byte, 0);
  EXPECT_NE(trace.hash(), 0U);
}

// A change of this number changes the hash of every recorded run.
TEST(HashTrace, StaysTheSame) {
  HashTrace trace;
  trace.on_episode(3);
  trace.on_message(2, 5, Array<float, 2>{{1.5F, -2.0F}});
  trace.on_message(0, 6, std::int64_t{-7});
  EXPECT_EQ(trace.hash(), 11442126881586188623U);
}

struct InputHooks {
  static constexpr bool kSeesInputs = true;
};

TEST(NoHooks, CostsNothing) {
  static_assert(std::is_empty_v<NoHooks>);
  static_assert(!sees_inputs<NoHooks> && !sees_inputs<HashTrace>);
  static_assert(sees_inputs<InputHooks>);
}

}  // namespace
}  // namespace eagerx

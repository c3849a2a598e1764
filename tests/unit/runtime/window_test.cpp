// eagerx/window.hpp: which messages of a ring a window shows, and how observations are padded.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <eagerx/window.hpp>

namespace eagerx {
namespace {

using Source = Rate<30>;

/// A ring of Capacity messages after `count` of them were sent; message `seq` has the value 100 +
/// seq.
template <std::uint32_t Capacity>
std::array<int, Capacity> ring_after(Seq count) {
  std::array<int, Capacity> ring{};
  for (Seq seq = 0; seq < count; ++seq) {
    ring[ring_position<Capacity>(seq)] = static_cast<int>(100 + seq);
  }
  return ring;
}

TEST(RingPosition, IsTheRemainderForAnyCapacity) {
  for (const Seq seq : {Seq{0}, Seq{1}, Seq{7}, Seq{8}, Seq{1000}, (Seq{1} << 32U) - 1,
                        Seq{1} << 32U, (Seq{1} << 32U) + 5, ~Seq{0}}) {
    EXPECT_EQ(ring_position<1>(seq), 0U);
    EXPECT_EQ(ring_position<8>(seq), seq % 8);
    EXPECT_EQ(ring_position<3>(seq), seq % 3);
    EXPECT_EQ(ring_position<1000>(seq), seq % 1000);
  }
}

TEST(Window, ShowsTheLastMessagesOldestFirst) {
  const auto ring = ring_after<8>(21);
  const Window<int, Source, 8, 5, false> window(ring.data(), 21, 5);
  ASSERT_EQ(window.size(), 5U);
  EXPECT_FALSE(window.empty());
  for (std::uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(window[i], static_cast<int>(116 + i));
    EXPECT_EQ(window.seq(i), 16U + i);
  }
  EXPECT_EQ(window.front(), 116);
  EXPECT_EQ(window.back(), 120);
}

TEST(Window, HoldsFewerMessagesThanItsSize) {
  const auto ring = ring_after<3>(2);
  const Window<int, Source, 3, 3, false> window(ring.data(), 2, 2);
  ASSERT_EQ(window.size(), 2U);
  EXPECT_EQ(window.front(), 100);
  EXPECT_EQ(window.back(), 101);
}

TEST(Window, IsEmptyBeforeTheFirstMessage) {
  const auto ring = ring_after<2>(0);
  const Window<int, Source, 2, 2, false> window(ring.data(), 0, 0);
  EXPECT_TRUE(window.empty());
  EXPECT_EQ(window.size(), 0U);
}

TEST(Window, ThatIsAlwaysFullStoresNoSize) {
  using Full = Window<int, Source, 4, 2, true>;
  using Partial = Window<int, Source, 4, 2, false>;
  struct PointerAndSeq {
    const void* pointer;
    Seq seq;
  };
  static_assert(sizeof(Full) == sizeof(PointerAndSeq));
  static_assert(sizeof(Partial) > sizeof(Full));
  const auto ring = ring_after<4>(6);
  const Full window(ring.data(), 6, 2);
  EXPECT_EQ(window.size(), 2U);
  EXPECT_EQ(window.front(), 104);
  EXPECT_EQ(window.back(), 105);
}

// A delayed connection: the window ends before the newest message of the ring.
TEST(Window, EndsWhereTheDelayPutsIt) {
  const auto ring = ring_after<8>(21);
  const Window<int, Source, 8, 2, false> window(ring.data(), 18, 2);
  EXPECT_EQ(window.front(), 116);
  EXPECT_EQ(window.back(), 117);
  EXPECT_EQ(window.seq(1), 17U);
}

TEST(Window, TellsWhenMessagesWereSent) {
  const auto ring = ring_after<4>(31);
  const Window<int, Source, 4, 2, true> window(ring.data(), 31, 2);
  EXPECT_EQ(window.sent_s<double>(0), 29.0 / 30.0);
  EXPECT_EQ(window.sent_s<float>(1), 1.0F);
}

TEST(Window, RefersToTheRingWithoutACopy) {
  const auto ring = ring_after<4>(3);
  const Window<int, Source, 4, 2, true> window(ring.data(), 3, 2);
  EXPECT_EQ(&window[0], &ring[1]);
  EXPECT_EQ(&window.back(), &ring[2]);
}

TEST(PaddedWindow, RepeatsTheOldestAtTheFront) {
  const auto ring = ring_after<4>(2);
  const PaddedWindow<int, Source, 4, 4, false> window(ring.data(), 2, 2);
  EXPECT_EQ(window.received(), 2U);
  EXPECT_EQ(window.size(), 4U);
  const std::array<int, 4> expected = {100, 100, 100, 101};
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(window[i], expected[i]) << i;
  EXPECT_EQ(window.back(), 101);
  EXPECT_EQ(window.unpadded().size(), 2U);
}

TEST(PaddedWindow, ShowsTheMessagesWhenThereAreEnough) {
  const auto ring = ring_after<4>(9);
  const PaddedWindow<int, Source, 4, 3, false> partial(ring.data(), 9, 3);
  const PaddedWindow<int, Source, 4, 3, true> full(ring.data(), 9, 3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(partial[i], static_cast<int>(106 + i));
    EXPECT_EQ(full[i], static_cast<int>(106 + i));
  }
  EXPECT_EQ(full.received(), 3U);
}

TEST(PaddedWindow, WithoutMessagesIsZero) {
  const std::array<float, 2> floats = {1, 2};
  const PaddedWindow<float, Source, 2, 2, false> of_floats(floats.data(), 0, 0);
  EXPECT_EQ(of_floats[0], 0.0F);
  EXPECT_EQ(of_floats.back(), 0.0F);

  const std::array<Array<double, 2>, 1> arrays = {{{{3, 4}}}};
  const PaddedWindow<Array<double, 2>, Source, 1, 1, false> of_arrays(arrays.data(), 0, 0);
  EXPECT_EQ(of_arrays[0][0], 0.0);
  EXPECT_EQ(of_arrays[0][1], 0.0);

  const std::array<int, 1> ints = {5};
  const PaddedWindow<int, Source, 1, 1, false> of_ints(ints.data(), 0, 0);
  EXPECT_EQ(of_ints.back(), 0);
}

}  // namespace
}  // namespace eagerx

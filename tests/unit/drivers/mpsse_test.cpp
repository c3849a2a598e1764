// models/links/ftdi/mpsse_batch.hpp: the bytes that go to the chip, after FTDI AN_108.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <models/links/ftdi/mpsse_batch.hpp>
#include <vector>

namespace eagerx::links {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes sent(const MpsseBatch& batch) {
  return {batch.bytes(), batch.bytes() + batch.size()};
}

class MpsseBatchTest : public ::testing::Test {
 protected:
  void SetUp() override { batch->use({true, true, 0}); }
  std::unique_ptr<MpsseBatch> batch = std::make_unique<MpsseBatch>();
};

TEST_F(MpsseBatchTest, DivisorsNeverTooFast) {
  EXPECT_EQ(MpsseBatch::divisor_of(30'000'000), 0);
  EXPECT_EQ(MpsseBatch::divisor_of(15'000'000), 1);
  EXPECT_EQ(MpsseBatch::divisor_of(10'000'000), 2);
  EXPECT_EQ(MpsseBatch::divisor_of(400'000), 74);
  EXPECT_EQ(MpsseBatch::divisor_of(1), 0xffff);
  EXPECT_EQ(MpsseBatch::divisor_of(0), 0);
  for (std::uint32_t hz = 1'000; hz < 40'000'000; hz += 7'919) {
    ASSERT_LE(30e6 / (MpsseBatch::divisor_of(hz) + 1), hz);
  }
}

TEST_F(MpsseBatchTest, SpiModeZero) {
  const Bytes out = {0xbe, 0xef};
  std::uint8_t in[2]{};
  batch->spi({1, 0, 15'000'000}, out.data(), in, 2);
  batch->finish();
  EXPECT_EQ(sent(*batch),
            (Bytes{0x8d, 0x86, 0x01, 0x00, 0x9e, 0x00, 0x00,  // phases, clock, push-pull
                   0x80, 0xf8, 0xfb,                          // at rest
                   0x80, 0xe8, 0xfb, 0x80, 0xe8, 0xfb, 0x80, 0xe8, 0xfb,  // select line 1 low
                   0x31, 0x01, 0x00, 0xbe, 0xef,                          // out falling, in rising
                   0x80, 0xf8, 0xfb, 0x80, 0xf8, 0xfb, 0x80, 0xf8, 0xfb, 0x87}));
  EXPECT_EQ(batch->reply_size(), 2U);
  const std::uint8_t reply[] = {0x12, 0x34};
  batch->deliver(reply);
  EXPECT_EQ(in[0], 0x12);
  EXPECT_EQ(in[1], 0x34);
  // The same again does not set the same again, and without an answer there is nothing to flush.
  batch->clear();
  batch->spi({1, 0, 15'000'000}, out.data(), nullptr, 2);
  batch->finish();
  EXPECT_EQ(batch->bytes()[0], 0x80);
  EXPECT_EQ(batch->bytes()[4 * 3], 0x11);
  EXPECT_EQ(batch->size(), 26U) << "without 87";
  // Until the state of the chip is not known any more.
  batch->forget();
  batch->spi({1, 0, 15'000'000}, out.data(), nullptr, 2);
  EXPECT_EQ(batch->bytes()[0], 0x8d);
}

// Of modes 1 and 3 the first edge is made with the select line low; the commands are those of a
// clock that starts at that level, and the clock is back at rest once the select line is high.
TEST_F(MpsseBatchTest, SpiModeOne) {
  const std::uint8_t byte = 0x55;
  std::uint8_t in = 0;
  batch->spi({0, 1, 0}, &byte, &in, 1);
  EXPECT_EQ(sent(*batch),
            (Bytes{0x8d, 0x86, 0x00, 0x00, 0x9e, 0x00, 0x00, 0x80, 0xf8, 0xfb,  //
                   0x80, 0xf0, 0xfb, 0x80, 0xf0, 0xfb, 0x80, 0xf0, 0xfb,        // select line 0
                   0x80, 0xf1, 0xfb, 0x34, 0x00, 0x00, 0x55,  // clock high; out rising, in falling
                   0x80, 0xf9, 0xfb, 0x80, 0xf8, 0xfb, 0x80, 0xf8, 0xfb, 0x80, 0xf8, 0xfb}));
}

TEST_F(MpsseBatchTest, SpiModesTwoAndThree) {
  const std::uint8_t byte = 0x55;
  std::uint8_t in = 0;
  batch->spi({0, 2, 0}, &byte, &in, 1);
  const Bytes two = sent(*batch);
  EXPECT_EQ(Bytes(two.begin() + 7, two.end()),
            (Bytes{0x80, 0xf9, 0xfb, 0x80, 0xf1, 0xfb, 0x80, 0xf1, 0xfb, 0x80, 0xf1, 0xfb,  //
                   0x34, 0x00, 0x00, 0x55, 0x80, 0xf9, 0xfb, 0x80, 0xf9, 0xfb, 0x80, 0xf9, 0xfb}));
  batch->clear();
  batch->spi({0, 3, 0}, &byte, nullptr, 1);
  EXPECT_EQ(sent(*batch),
            (Bytes{0x80, 0xf9, 0xfb, 0x80, 0xf1, 0xfb, 0x80, 0xf1, 0xfb, 0x80, 0xf1, 0xfb,  //
                   0x80, 0xf0, 0xfb, 0x11, 0x00, 0x00, 0x55,  // clock low; out falling
                   0x80, 0xf8, 0xfb, 0x80, 0xf9, 0xfb, 0x80, 0xf9, 0xfb, 0x80, 0xf9, 0xfb}));
  batch->spi({0, 4, 0}, &byte, &in, 1);
  EXPECT_EQ(batch->error(), BusError::unsupported);
}

TEST_F(MpsseBatchTest, I2cWithoutOpenDrainReleasesByDirection) {
  batch->use({false, false, 0});
  BusError status{};
  std::uint8_t in = 0;
  const std::uint8_t reg = 0x75;
  batch->i2c({0x68, 400'000}, &reg, 1, &in, 1, status);
  const Bytes bytes = sent(*batch);
  for (std::size_t i = 0; i + 2 < bytes.size(); ++i) {
    EXPECT_NE(bytes[i], 0x9e) << "only the FT232H has it";
  }
  EXPECT_EQ(batch->reply_size(), 4U) << "three acknowledges and a byte";
  const std::uint8_t reply[] = {0, 0, 1, 0x68};
  batch->deliver(reply);
  EXPECT_EQ(in, 0x68);
  EXPECT_EQ(status, BusError::nak) << "the repeated address was not acknowledged";
  bool level = false;
  batch->read_pin(0, level);
  EXPECT_EQ(batch->error(), BusError::unsupported) << "no high byte on a FT4232H";
}

TEST_F(MpsseBatchTest, TooMuchIsRefusedAsAWhole) {
  const std::array<std::uint8_t, 512> bytes{};
  std::array<std::uint8_t, 512> in{};
  for (int i = 0; i < 2; ++i) batch->spi({0, 0, 0}, bytes.data(), in.data(), bytes.size());
  EXPECT_EQ(batch->error(), BusError::none);
  batch->spi({0, 0, 0}, bytes.data(), in.data(), 1);
  EXPECT_EQ(batch->error(), BusError::full) << "more answer than the chip can hold";
  batch->clear();
  for (int i = 0; i < 9; ++i) batch->spi({0, 0, 0}, bytes.data(), nullptr, bytes.size());
  EXPECT_EQ(batch->error(), BusError::full);
  EXPECT_LE(batch->size(), MpsseBatch::kMaxBytes);
}

}  // namespace
}  // namespace eagerx::links

// models/drivers: encoder and converter on SPI, against their data sheets.
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <models/drivers/as5048/as5048.hpp>
#include <models/drivers/mcp4921/mcp4921.hpp>

#include "tests/unit/drivers/recorded_bus.hpp"

namespace eagerx::drivers {
namespace {

using testing::Bytes;
using testing::RecordedBus;
using Encoder = MagneticEncoder<As5048A>;

TEST(MagneticEncoder, ReadingCommandsOfTheDataSheets) {
  EXPECT_EQ(Encoder::read_command(0x3fff), 0xffff);  // angle: parity 1, read 1, address
  EXPECT_EQ(Encoder::read_command(0x3ffd), 0x7ffd);
  EXPECT_EQ(Encoder::read_command(0x3ffe), 0x7ffe);
  EXPECT_EQ(Encoder::read_command(0x0001), 0x4001);
  EXPECT_EQ(Encoder::read_command(0x3ffc), 0xfffc);
}

TEST(MagneticEncoder, EveryWordHasEvenParity) {
  for (unsigned word = 0; word < 0x8000U; ++word) {
    const std::uint16_t coded = Encoder::with_parity(static_cast<std::uint16_t>(word));
    ASSERT_EQ(std::popcount(coded) % 2, 0) << word;
    ASSERT_EQ(coded & 0x7fffU, word);
    ASSERT_EQ(Encoder::is_odd(coded), false);
  }
}

/// A sample whose answers are `angle` and `diagnostics`.
BusError sample(Encoder& encoder, std::uint16_t angle, std::uint16_t diagnostics,
                std::uint16_t& counts) {
  RecordedBus bus;
  bus.answers = {{high_byte(angle), low_byte(angle)},
                 {high_byte(diagnostics), low_byte(diagnostics)}};
  encoder.request(bus, 0);
  return encoder.angle(counts);
}

constexpr std::uint16_t kGood = Encoder::with_parity(0x0180);  // OCF, AGC 128

TEST(MagneticEncoder, SendsThreeWordsInModeOne) {
  RecordedBus bus;
  Encoder encoder;
  encoder.request(bus, 2);
  EXPECT_EQ(bus.sent, (std::vector<Bytes>{{0xff, 0xff}, {0x7f, 0xfd}, {0x00, 0x00}}));
  for (const SpiDevice device : bus.spi_devices) {
    EXPECT_EQ(device.select, 2);
    EXPECT_EQ(device.mode, 1);
    EXPECT_LE(device.max_hz, 10'000'000U);
  }
}

TEST(MagneticEncoder, AllAnglesHighByteFirst) {
  Encoder encoder;
  for (unsigned angle = 0; angle < Encoder::kCountsPerTurn; ++angle) {
    std::uint16_t counts = 0xffff;
    const auto word = Encoder::with_parity(static_cast<std::uint16_t>(angle));
    ASSERT_EQ(sample(encoder, word, kGood, counts), BusError::none);
    ASSERT_EQ(counts, angle);
  }
}

TEST(MagneticEncoder, FindsEverySingleBitThatIsFlipped) {
  for (unsigned bit = 0; bit < 16; ++bit) {
    Encoder encoder;
    std::uint16_t counts = 77;
    const auto flipped = static_cast<std::uint16_t>(1U << bit);
    const auto angle = Encoder::with_parity(0x1234);
    EXPECT_EQ(sample(encoder, angle ^ flipped, kGood, counts), BusError::parity);
    EXPECT_EQ(sample(encoder, angle, kGood ^ flipped, counts), BusError::parity);
    EXPECT_EQ(counts, 77) << "a bad answer must not be taken";
  }
}

TEST(MagneticEncoder, FindsStuckLinesAndWhatTheChipReports) {
  Encoder encoder;
  std::uint16_t counts = 0;
  EXPECT_EQ(sample(encoder, 0x0000, 0x0000, counts), BusError::not_ready);  // stuck at 0
  EXPECT_EQ(sample(encoder, 0xffff, 0xffff, counts), BusError::refused);    // stuck at 1
  const auto angle = Encoder::with_parity(100);
  EXPECT_EQ(sample(encoder, angle, Encoder::with_parity(0x0380), counts), BusError::not_ready);
  EXPECT_EQ(sample(encoder, angle, Encoder::with_parity(0x0900), counts), BusError::out_of_range);
  EXPECT_EQ(counts, 100);
}

TEST(MagneticEncoder, ClearsTheErrorFlagWithTheNextSample) {
  Encoder encoder;
  std::uint16_t counts = 0;
  EXPECT_EQ(sample(encoder, Encoder::with_parity(0x4000 | 5), kGood, counts), BusError::refused);
  RecordedBus bus;
  encoder.request(bus, 0);
  EXPECT_EQ(bus.sent.size(), 4U);
  EXPECT_EQ(bus.sent.front(), (Bytes{0x40, 0x01}));
  EXPECT_EQ(sample(encoder, Encoder::with_parity(5), kGood, counts), BusError::none);
  bus = {};
  encoder.request(bus, 0);
  EXPECT_EQ(bus.sent.size(), 3U);
}

TEST(Mcp4921, CommandsOfTheDataSheet) {
  EXPECT_EQ(Mcp4921::write_command(0x000), 0x3000);
  EXPECT_EQ(Mcp4921::write_command(0x800), 0x3800);
  EXPECT_EQ(Mcp4921::write_command(0xfff), 0x3fff);
  EXPECT_EQ(Mcp4921::write_command(0xffff), 0x3fff) << "limited, never another command";
  EXPECT_EQ(Mcp4921::shutdown_command() & 0x1000U, 0U);
}

TEST(Mcp4921, CodesAreNearestAndLimited) {
  // One step is V_REF/4096: 1 mV with 4.096 V.
  EXPECT_EQ(Mcp4921::code_of(0.0, 4.096), 0);
  EXPECT_EQ(Mcp4921::code_of(2.048, 4.096), 2048);
  EXPECT_EQ(Mcp4921::code_of(0.0014, 4.096), 1);
  EXPECT_EQ(Mcp4921::code_of(0.0016, 4.096), 2);
  EXPECT_EQ(Mcp4921::code_of(4.095, 4.096), 4095);
  EXPECT_EQ(Mcp4921::code_of(9.0F, 4.096F), 4095);
  EXPECT_EQ(Mcp4921::code_of(-1.0, 4.096), 0);
  EXPECT_EQ(Mcp4921::code_of(std::numeric_limits<double>::quiet_NaN(), 4.096), 0);
  EXPECT_EQ(Mcp4921::code_of(std::numeric_limits<float>::infinity(), 4.096F), 4095);
}

TEST(Mcp4921, SendsHighByteFirstInModeZero) {
  RecordedBus bus;
  Mcp4921::write(bus, 1, 0xabc);
  ASSERT_EQ(bus.sent.size(), 1U);
  EXPECT_EQ(bus.sent[0], (Bytes{0x3a, 0xbc}));
  EXPECT_EQ(bus.spi_devices[0].mode, 0);
  EXPECT_EQ(bus.spi_devices[0].select, 1);
}

}  // namespace
}  // namespace eagerx::drivers

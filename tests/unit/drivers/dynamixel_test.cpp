// models/drivers/dynamixel: packets of the e-Manual, stuffing, checks.
#include <gtest/gtest.h>

#include <models/drivers/dynamixel/dynamixel.hpp>

#include "tests/unit/drivers/recorded_bus.hpp"

namespace eagerx::drivers {
namespace {

using testing::Bytes;
using testing::RecordedBus;

template <class Packet>
Bytes bytes_of(const Packet& packet) {
  return {packet.data(), packet.data() + packet.size()};
}

TEST(Dynamixel, PacketsOfTheManual) {
  const DynamixelX servo(1);
  EXPECT_EQ(bytes_of(servo.ping()),
            (Bytes{0xff, 0xff, 0xfd, 0x00, 0x01, 0x03, 0x00, 0x01, 0x19, 0x4e}));
  EXPECT_EQ(bytes_of(servo.read(132, 4)), (Bytes{0xff, 0xff, 0xfd, 0x00, 0x01, 0x07, 0x00, 0x02,
                                                 0x84, 0x00, 0x04, 0x00, 0x1d, 0x15}));
  EXPECT_EQ(bytes_of(servo.write(116, 512, 4)),
            (Bytes{0xff, 0xff, 0xfd, 0x00, 0x01, 0x09, 0x00, 0x03, 0x74, 0x00, 0x00, 0x02, 0x00,
                   0x00, 0xca, 0x89}));
}

TEST(Dynamixel, StatusPacketsOfTheManual) {
  // Answer to ping: model 1030, firmware 38.
  const Bytes ping = {0xff, 0xff, 0xfd, 0x00, 0x01, 0x07, 0x00,
                      0x55, 0x00, 0x06, 0x04, 0x26, 0x65, 0x5d};
  std::uint8_t parameters[4]{};
  EXPECT_EQ(dynamixel_status(ping.data(), ping.size(), 1, parameters, 3), BusError::none);
  EXPECT_EQ(little_endian(parameters), 1030);
  EXPECT_EQ(parameters[2], 38);

  const Bytes position = {0xff, 0xff, 0xfd, 0x00, 0x01, 0x08, 0x00, 0x55,
                          0x00, 0xa6, 0x00, 0x00, 0x00, 0x8c, 0xc0};
  RecordedBus bus;
  bus.answers = {position};
  std::int32_t counts = 0;
  EXPECT_EQ(DynamixelX(1).position(bus, counts), BusError::none);
  EXPECT_EQ(counts, 166);
}

TEST(Dynamixel, EveryFlippedBitIsFound) {
  const Bytes good = {0xff, 0xff, 0xfd, 0x00, 0x01, 0x08, 0x00, 0x55,
                      0x00, 0xa6, 0x00, 0x00, 0x00, 0x8c, 0xc0};
  std::uint8_t parameters[4]{};
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    Bytes bad = good;
    bad[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_NE(dynamixel_status(bad.data(), bad.size(), 1, parameters, 4), BusError::none) << bit;
  }
  for (std::size_t n = 0; n < good.size(); ++n) {
    EXPECT_EQ(dynamixel_status(good.data(), n, 1, parameters, 4), BusError::frame);
  }
}

/// A status packet of servo 1, built with the packets' own stuffing.
Bytes status(std::uint8_t error, const Bytes& parameters) {
  Bytes all = {error};
  all.insert(all.end(), parameters.begin(), parameters.end());
  DynamixelPacket<16> packet;
  packet.build(1, 0x55, all.data(), all.size());
  return bytes_of(packet);
}

TEST(Dynamixel, TheHeaderInsideIsStuffedAndTakenOut) {
  const Bytes packet = status(0, {0xff, 0xff, 0xfd, 0xff});  // -131073
  EXPECT_EQ(packet.size(), 16U);
  EXPECT_EQ(Bytes(packet.begin() + 9, packet.begin() + 14), (Bytes{0xff, 0xff, 0xfd, 0xfd, 0xff}));
  RecordedBus bus;
  bus.answers = {{packet.begin(), packet.begin() + 15}, {packet.back()}};
  std::int32_t counts = 0;
  EXPECT_EQ(DynamixelX(1).position(bus, counts), BusError::none);
  EXPECT_EQ(counts, static_cast<std::int32_t>(0xfffdffffU));
  // FD FD that is not a stuffing stays.
  std::uint8_t parameters[4]{};
  const Bytes plain = status(0, {0xff, 0xfd, 0xfd, 0x01});
  EXPECT_EQ(dynamixel_status(plain.data(), plain.size(), 1, parameters, 4), BusError::none);
  EXPECT_EQ(Bytes(parameters, parameters + 4), (Bytes{0xff, 0xfd, 0xfd, 0x01}));
}

TEST(Dynamixel, ErrorsAreReported) {
  std::uint8_t parameters[4]{};
  const Bytes limit = status(0x06, {1, 2, 3, 4});
  EXPECT_EQ(dynamixel_status(limit.data(), limit.size(), 1, parameters, 4), BusError::refused);
  const Bytes alert = status(0x80, {1, 2, 3, 4});
  EXPECT_EQ(dynamixel_status(alert.data(), alert.size(), 1, parameters, 4), BusError::none);
  EXPECT_EQ(dynamixel_status(alert.data(), alert.size(), 2, parameters, 4), BusError::frame);
  EXPECT_EQ(dynamixel_status(alert.data(), alert.size(), 1, parameters, 3), BusError::frame);
  RecordedBus silent;
  std::int32_t counts = 0;
  EXPECT_EQ(DynamixelX(1).position(silent, counts), BusError::timeout);
  const auto asked = [&](const Bytes& packet) {
    RecordedBus bus;
    bus.answers = {packet};
    return DynamixelX(1).position(bus, counts);
  };
  EXPECT_EQ(asked(status(0x04, {})), BusError::refused);  // an error alone has no parameters
  EXPECT_EQ(asked(status(0x00, {})), BusError::frame);
  EXPECT_EQ(asked(status(0x00, {1, 2, 3, 4, 5, 6, 7})), BusError::frame);
  Bytes cut = status(0x00, {1, 2, 3, 4});
  cut.pop_back();
  EXPECT_EQ(asked(cut), BusError::short_reply);
  EXPECT_EQ(asked(Bytes(11, 0xff)), BusError::frame);
  DynamixelPacket<2> packet;
  packet.build(1, 3, parameters, 3);
  EXPECT_EQ(packet.size(), 0U);
}

}  // namespace
}  // namespace eagerx::drivers

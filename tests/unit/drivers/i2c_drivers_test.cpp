// models/drivers: chips on I2C, against their data sheets.
#include <gtest/gtest.h>

#include <limits>
#include <models/drivers/mpu6050/mpu6050.hpp>
#include <models/drivers/pca9685/pca9685.hpp>

#include "tests/unit/drivers/recorded_bus.hpp"

namespace eagerx::drivers {
namespace {

using testing::Bytes;
using testing::RecordedBus;

TEST(Mpu6050, Configuration) {
  RecordedBus bus;
  bus.answers = {{0x68}};
  Mpu6050 chip(0x69, AccelerationRange::g4, GyroRange::dps1000);
  chip.configure(bus, 3);
  EXPECT_EQ(bus.sent,
            (std::vector<Bytes>{{0x6b, 0x01}, {0x1a, 0x03}, {0x1b, 0x10}, {0x1c, 0x08}, {0x75}}));
  EXPECT_EQ(bus.addresses, std::vector<std::uint8_t>(5, 0x69));
  EXPECT_EQ(chip.configured(), BusError::none);
}

TEST(Mpu6050, AnotherChipAndNoChip) {
  RecordedBus bus;
  bus.answers = {{0x70}};
  Mpu6050 chip;
  chip.configure(bus);
  EXPECT_EQ(chip.configured(), BusError::frame);
  bus.i2c_status = BusError::nak;
  chip.configure(bus);
  EXPECT_EQ(chip.configured(), BusError::nak);
  InertialSample<float> sample{};
  chip.request(bus);
  EXPECT_EQ(chip.sample(sample), BusError::nak);
}

TEST(Mpu6050, ScalesOfTheDataSheet) {
  // Product specification 6.1 and 6.2: 16384 digits per g at ±2 g, 131 per °/s at ±250 °/s;
  // register map 4.18: temperature / 340 + 36.53.
  RecordedBus bus;
  bus.answers = {
      {0x40, 0x00, 0xc0, 0x00, 0x00, 0x00, 0x01, 0x54, 0x00, 0x83, 0xff, 0x7d, 0x80, 0x00}};
  Mpu6050 chip;
  chip.request(bus);
  EXPECT_EQ(bus.sent, (std::vector<Bytes>{{0x3b}}));
  InertialSample<double> sample{};
  ASSERT_EQ(chip.sample(sample), BusError::none);
  EXPECT_DOUBLE_EQ(sample.acceleration[0], 9.80665);
  EXPECT_DOUBLE_EQ(sample.acceleration[1], -9.80665);
  EXPECT_DOUBLE_EQ(sample.acceleration[2], 0.0);
  EXPECT_DOUBLE_EQ(sample.temperature, 37.53);
  EXPECT_NEAR(sample.angular_velocity[0], 0.0174532925, 1e-9);
  EXPECT_NEAR(sample.angular_velocity[1], -0.0174532925, 1e-9);
  EXPECT_NEAR(sample.angular_velocity[2], -32768 / 131.0 * 0.0174532925, 1e-6);
}

TEST(Mpu6050, Ranges) {
  const Bytes words = {0x08, 0x00, 0, 0, 0, 0, 0, 0, 0x00, 0xa4, 0, 0, 0, 0};
  RecordedBus bus;
  bus.answers = {words};
  Mpu6050 chip(0x68, AccelerationRange::g16, GyroRange::dps2000);
  chip.request(bus);
  InertialSample<double> sample{};
  ASSERT_EQ(chip.sample(sample), BusError::none);
  EXPECT_DOUBLE_EQ(sample.acceleration[0], 9.80665);                 // 2048 digits per g
  EXPECT_NEAR(sample.angular_velocity[0], 10 * 0.0174532925, 1e-8);  // 16.4 per °/s
}

TEST(Mpu6050, NothingButZerosIsNoSample) {
  RecordedBus bus;  // acknowledges and sends zeros: a chip that sleeps, or a line stuck at 0
  Mpu6050 chip;
  chip.request(bus);
  InertialSample<float> sample{};
  EXPECT_EQ(chip.sample(sample), BusError::not_ready);
}

TEST(Pca9685, PrescaleOfTheDataSheet) {
  EXPECT_EQ(Pca9685::prescale(200.0), 30);  // the example of 7.3.5
  EXPECT_EQ(Pca9685::prescale(50.0), 121);
  EXPECT_EQ(Pca9685::prescale(1526.0), 3);
  EXPECT_EQ(Pca9685::prescale(24.0), 253);
  EXPECT_EQ(Pca9685::prescale(1.0), 255);
  EXPECT_EQ(Pca9685::prescale(1e9), 3);
  EXPECT_EQ(Pca9685::prescale(std::numeric_limits<double>::quiet_NaN()), 3);
}

TEST(Pca9685, RegistersOfTheDataSheetsExamples) {
  // 7.3.3, example 1: delay 10 % = 409 (199h), on for 20 % = 819, off at 1228 (4CCh).
  const auto first = Pca9685::channel(409, 819);
  EXPECT_EQ(Bytes(first.bytes, first.bytes + 4), (Bytes{0x99, 0x01, 0xcc, 0x04}));
  // Example 2: delay 90 % = 3685 (E65h), on for 90 % = 3686, past the end: off at 3275 (CCBh).
  const auto second = Pca9685::channel(3685, 3686);
  EXPECT_EQ(Bytes(second.bytes, second.bytes + 4), (Bytes{0x65, 0x0e, 0xcb, 0x0c}));
}

TEST(Pca9685, ADelayPastTheEndIsNotAlwaysOn) {
  const auto late = Pca9685::channel(4096 + 409, 819);
  EXPECT_EQ(Bytes(late.bytes, late.bytes + 4), (Bytes{0x99, 0x01, 0xcc, 0x04}));
}

TEST(Pca9685, FullyOnAndOff) {
  const auto off = Pca9685::channel(0, 0);
  EXPECT_EQ(Bytes(off.bytes, off.bytes + 4), (Bytes{0, 0, 0, 0x10}));
  const auto on = Pca9685::channel(0, 4096);
  EXPECT_EQ(Bytes(on.bytes, on.bytes + 4), (Bytes{0, 0x10, 0, 0}));
  EXPECT_EQ(Pca9685::width_of(0.5), 2048);
  EXPECT_EQ(Pca9685::width_of(-0.5), 0);
  EXPECT_EQ(Pca9685::width_of(7.0F), 4096);
  EXPECT_EQ(Pca9685::width_of(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Pca9685, TransfersAndStatus) {
  RecordedBus bus;
  Pca9685 chip(0x41);
  chip.configure(bus, 200.0);
  EXPECT_EQ(bus.sent, (std::vector<Bytes>{{0x00, 0x30}, {0xfe, 0x1e}, {0x00, 0x20}, {0x01, 0x04}}));
  bus.sent.clear();
  EXPECT_EQ(chip.write_channel(bus, 15, Pca9685::channel(0, 1)), BusError::none);
  EXPECT_EQ(bus.sent, (std::vector<Bytes>{{0x42, 0, 0, 1, 0}}));
  EXPECT_EQ(chip.write_channel(bus, 16, Pca9685::channel(0, 1)), BusError::out_of_range);
  EXPECT_EQ(chip.status(), BusError::none);
  bus.i2c_status = BusError::nak;
  chip.all_off(bus);
  EXPECT_EQ(bus.sent.back(), (Bytes{0xfa, 0, 0, 0, 0x10}));
  EXPECT_EQ(chip.status(), BusError::nak);
}

}  // namespace
}  // namespace eagerx::drivers

// models/links/ftdi over the real libftdi and the emulated chip: every bus, every fault.
#include <gtest/gtest.h>

#include <memory>
#include <models/drivers/as5048/as5048.hpp>
#include <models/drivers/dynamixel/dynamixel.hpp>
#include <models/drivers/mcp4921/mcp4921.hpp>
#include <models/drivers/mpu6050/mpu6050.hpp>
#include <models/drivers/pca9685/pca9685.hpp>
#include <models/links/ftdi/linux/ftdi_link.hpp>
#include <models/links/ftdi/linux/ftdi_uart.hpp>
#include <targets/emulated-ftdi/emulator.hpp>
#include <utility>
#include <vector>

namespace eagerx::links {
namespace {

using drivers::As5048A;
using drivers::MagneticEncoder;
using drivers::Mcp4921;
using emulated::emulator;
using emulated::Fault;

constexpr FtdiSelection kAny{0x0403, 0x6014, "", "", 'A'};
constexpr int kTimeoutMs = 10;
constexpr std::uint32_t kMaxHz = 5'000'000;

class FtdiLinkTest : public ::testing::Test {
 protected:
  void SetUp() override {
    emulator().time().pass(emulated::kNsPerSecond);  // an adapter that was pulled out is back
    ASSERT_TRUE(link.open(kAny, kTimeoutMs, kMaxHz));
  }
  void TearDown() override { link.close(); }

  BusError sample() {
    encoder.request(link, 0);
    const BusError error = link.run();
    return error != BusError::none ? error : encoder.angle(counts);
  }

  FtdiLink link;
  MagneticEncoder<As5048A> encoder;
  std::uint16_t counts = 0;
};

TEST(FtdiSelection, ByProductDescriptionAndSerial) {
  FtdiLink link;
  emulator().time().pass(emulated::kNsPerSecond);
  EXPECT_FALSE(link.open({0x0403, 0x6010, "", "", 'A'}, kTimeoutMs, kMaxHz));
  EXPECT_FALSE(link.open({0x0403, 0x6014, "ANOTHER", "", 'A'}, kTimeoutMs, kMaxHz));
  EXPECT_FALSE(link.open({0x0403, 0x6014, "", "Another", 'A'}, kTimeoutMs, kMaxHz));
  EXPECT_TRUE(link.open({0x0403, 0x6014, "EAGERX01", "Emulated FT232H", 'A'}, kTimeoutMs, kMaxHz));
  link.close();
}

/// Chips with several interfaces: the devices are on one of them, and only that one answers.
class SeveralInterfaces : public ::testing::Test {
 protected:
  void SetUp() override { emulator().time().pass(emulated::kNsPerSecond); }
  void TearDown() override {
    link.close();
    emulator().set_model(emulated::kFt232h, 0);
  }
  bool open(int product, char interface) {
    return link.open({0x0403, product, "", "", interface}, kTimeoutMs, kMaxHz);
  }
  BusError sample() {
    std::uint16_t counts = 0;
    encoder.request(link, 0);
    const BusError error = link.run();
    return error != BusError::none ? error : encoder.angle(counts);
  }
  FtdiLink link;
  MagneticEncoder<As5048A> encoder;
};

TEST_F(SeveralInterfaces, Ft2232hBothHaveMpsse) {
  for (const char wired : {'A', 'B'}) {
    emulator().set_model(emulated::kFt2232h, static_cast<unsigned>(wired - 'A'));
    EXPECT_FALSE(open(0x6014, wired)) << "that would be a FT232H";
    const auto before = emulator().usb().elsewhere;
    ASSERT_TRUE(open(0x6010, wired));
    for (int i = 0; i < 10; ++i) EXPECT_EQ(sample(), BusError::none);
    EXPECT_EQ(emulator().usb().elsewhere, before);
    EXPECT_EQ(emulator().chip().wrong_modes(), 0U);
    bool level = false;
    link.read_pin(0, level);
    EXPECT_EQ(link.run(), BusError::none) << "it has a high byte";
    EXPECT_FALSE(open(0x6010, wired == 'A' ? 'B' : 'A')) << "nothing is wired to it that answers";
    EXPECT_GT(emulator().usb().elsewhere, before);
    EXPECT_FALSE(open(0x6010, 'C')) << "there is none";
  }
}

TEST_F(SeveralInterfaces, Ft4232hHasMpsseOnTheFirstTwo) {
  for (const char wired : {'A', 'B'}) {
    emulator().set_model(emulated::kFt4232h, static_cast<unsigned>(wired - 'A'));
    ASSERT_TRUE(open(0x6011, wired));
    EXPECT_EQ(sample(), BusError::none);
    bool level = false;
    link.read_pin(0, level);
    EXPECT_EQ(link.run(), BusError::unsupported) << "it has no high byte";
  }
  for (const char wired : {'C', 'D'}) {
    emulator().set_model(emulated::kFt4232h, static_cast<unsigned>(wired - 'A'));
    EXPECT_FALSE(open(0x6011, wired)) << "a serial line only";
  }
}

TEST_F(SeveralInterfaces, I2cWithoutOpenDrain) {
  emulator().set_model(emulated::kFt2232h, 1);
  ASSERT_TRUE(open(0x6010, 'B'));
  const std::uint8_t who_am_i = 0x75;
  std::uint8_t answer = 0;
  BusError status = BusError::none;
  link.i2c({0x68, 400'000}, &who_am_i, 1, &answer, 1, status);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(status, BusError::none);
  EXPECT_EQ(answer, 0x68);
}

TEST_F(FtdiLinkTest, EncoderAndConverterInOneRoundTrip) {
  const auto before = emulator().usb();
  const auto writes = emulator().converter().writes();
  encoder.request(link, 0);
  Mcp4921::write(link, 1, Mcp4921::code_of(2.5, 4.096));
  ASSERT_EQ(link.run(), BusError::none);
  ASSERT_EQ(encoder.angle(counts), BusError::none);
  EXPECT_NEAR(counts, 8192, 1) << "the pendulum hangs down";
  EXPECT_EQ(emulator().converter().writes(), writes + 1);
  EXPECT_NEAR(emulator().pendulum().voltage(), 2.5 - 2.048, 1e-9);
  EXPECT_EQ(emulator().usb().batches, before.batches + 1);
  EXPECT_EQ(emulator().usb().out, before.out + 1);
  EXPECT_EQ(emulator().usb().in, before.in + 1);
  EXPECT_EQ(emulator().chip().wrong_modes(), 0U);
  EXPECT_EQ(link.counts().round_trips, 1U);
  Mcp4921::write(link, 1, 2048);
  ASSERT_EQ(link.post(), BusError::none);
  EXPECT_EQ(emulator().usb().in, before.in + 1) << "nothing to wait for";
  EXPECT_EQ(link.counts().one_way, 1U);
}

TEST_F(FtdiLinkTest, ManySamples) {
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(sample(), BusError::none) << i;
  EXPECT_EQ(link.counts().round_trips, 2000U);
}

TEST_F(FtdiLinkTest, WrongModesAndSelectsAreRefusedBeforeAnythingIsSent) {
  const auto before = emulator().usb().out;
  const std::uint8_t byte = 0;
  link.spi({5, 0, 1}, &byte, nullptr, 1);
  EXPECT_EQ(link.run(), BusError::unsupported);
  link.spi({0, 4, 1}, &byte, nullptr, 1);
  EXPECT_EQ(link.run(), BusError::unsupported);
  std::uint8_t answer[2000]{};
  link.spi({0, 0, 1}, answer, answer, sizeof answer);
  EXPECT_EQ(link.run(), BusError::full);
  EXPECT_EQ(emulator().usb().out, before);
  EXPECT_EQ(sample(), BusError::none);
}

/// A device of any mode, which answers with the previous word.
class Echo final : public emulated::SpiSlave {
 public:
  unsigned mode() const override { return mode_; }
  void select(std::int64_t /*now_ns*/) override {}
  void release(std::int64_t /*now_ns*/) override {}
  std::uint8_t exchange(std::uint8_t byte) override { return std::exchange(last_, byte); }
  void power_lost() override {}
  void use(unsigned mode) {
    mode_ = mode;
    last_ = 0x5a;
  }

 private:
  unsigned mode_ = 0;
  std::uint8_t last_ = 0;
};

TEST_F(FtdiLinkTest, EverySpiModeIsUnderstoodByItsDevicesOnly) {
  static Echo echo;  // wired until the program ends
  constexpr std::uint8_t kSelect = 4;
  emulator().chip().wire(kSelect, echo);
  const std::uint8_t out[] = {0x12, 0x34};
  for (unsigned device = 0; device < 4; ++device) {
    for (std::uint8_t mode = 0; mode < 4; ++mode) {
      echo.use(device);
      const auto wrong = emulator().chip().wrong_modes();
      std::uint8_t in[2]{};
      link.spi({kSelect, mode, 1'000'000}, out, in, 2);
      ASSERT_EQ(link.run(), BusError::none);
      EXPECT_EQ(in[0] == 0x5a && in[1] == 0x12, mode == device) << "mode " << int{mode};
      EXPECT_EQ(emulator().chip().wrong_modes() - wrong, mode == device ? 0U : 2U);
    }
  }
}

// Commands for mode 1 that a device must not understand: no edge before the first bit, the wrong
// edges, three-phase clocking, the clock moved together with the select line.
TEST(FtdiChip, WrongEdgesAreNoticed) {
  static Echo echo;
  auto chip = std::make_unique<emulated::Chip>();
  chip->wire(0, echo);
  const auto wrong = [&](std::vector<std::uint8_t> bytes) {
    emulated::Fifo answer;
    echo.use(1);
    chip->set_mode(2);
    const auto before = chip->wrong_modes();
    bytes.insert(bytes.begin(), {0x80, 0xf8, 0xfb});
    chip->take(bytes.data(), bytes.size(), 0, answer);
    return chip->wrong_modes() - before;
  };
  constexpr std::uint8_t kPins = 0x80;
  EXPECT_EQ(wrong({kPins, 0xf0, 0xfb, kPins, 0xf1, 0xfb, 0x34, 0, 0, 1, kPins, 0xf9, 0xfb}), 0U);
  EXPECT_EQ(wrong({kPins, 0xf0, 0xfb, 0x34, 0, 0, 1, kPins, 0xf8, 0xfb}), 1U);
  EXPECT_EQ(wrong({kPins, 0xf1, 0xfb, 0x34, 0, 0, 1, kPins, 0xf9, 0xfb}), 2U);
  constexpr std::uint8_t kWrong[] = {0x30, 0x31, 0x35};
  for (const std::uint8_t opcode : kWrong) {
    EXPECT_EQ(wrong({kPins, 0xf0, 0xfb, kPins, 0xf1, 0xfb, opcode, 0, 0, 1, kPins, 0xf9, 0xfb}),
              1U);
  }
  EXPECT_EQ(wrong({kPins, 0xf0, 0xfb, kPins, 0xf1, 0xfb, 0x34, 0, 0, 1, kPins, 0xf8, 0xfb}), 1U);
  EXPECT_EQ(wrong({0x8c, kPins, 0xf0, 0xfb, 0x35, 0, 0, 1, kPins, 0xf8, 0xfb, 0x8d}), 1U);
}

TEST_F(FtdiLinkTest, WhatARefusedBatchWouldHaveSetIsSetByTheNext) {
  const auto wrong = emulator().chip().wrong_modes();
  Mcp4921::write(link, 1, 2048);  // another mode and clock than the encoder's
  ASSERT_EQ(link.run(), BusError::none);
  const std::uint8_t byte = 0;
  encoder.request(link, 0);
  link.spi({0, 4, 1}, &byte, nullptr, 1);
  ASSERT_EQ(link.run(), BusError::unsupported);
  EXPECT_EQ(sample(), BusError::none);
  EXPECT_EQ(emulator().chip().wrong_modes(), wrong);
}

TEST_F(FtdiLinkTest, PinsReadBack) {
  bool in = false;
  emulator().chip().set_high_inputs(0x20);
  link.write_pin(3, true);
  link.read_pin(5, in);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_TRUE(in);
  EXPECT_EQ(emulator().chip().high_pins(), 0x08);
  link.write_pin(3, false);
  link.read_pin(4, in);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_FALSE(in);
  EXPECT_EQ(emulator().chip().high_pins(), 0x00);
  link.write_pin(8, true);
  EXPECT_EQ(link.run(), BusError::unsupported);
}

TEST_F(FtdiLinkTest, I2cChipsInOneRoundTrip) {
  drivers::Mpu6050 imu;
  drivers::Pca9685 pwm;
  imu.configure(link);
  pwm.configure(link, 50.0);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(imu.configured(), BusError::none);
  EXPECT_EQ(pwm.status(), BusError::none);
  drivers::InertialSample<float> values{};
  imu.request(link);
  pwm.write_channel(link, 2, drivers::Pca9685::channel(0, 300));
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(imu.sample(values), BusError::none);
  EXPECT_FLOAT_EQ(values.acceleration[2], 9.80665F);
  EXPECT_EQ(pwm.status(), BusError::none);
  EXPECT_EQ(link.counts().round_trips, 2U);
  // It loses power and comes back asleep.
  const std::uint8_t sleep[] = {0x6b, 0x40};
  BusError written{};
  link.i2c({0x68, 400'000}, sleep, 2, nullptr, 0, written);
  imu.request(link);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(imu.sample(values), BusError::not_ready);
  // The registers, read back.
  const std::uint8_t reg = 0x06 + 4 * 2;
  std::uint8_t channel[4]{};
  BusError status{};
  link.i2c({0x40, 400'000}, &reg, 1, channel, 4, status);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(status, BusError::none);
  EXPECT_EQ(channel[2], 300 & 0xff);
  EXPECT_EQ(channel[3], 300 >> 8);
  // SPI still works after I2C.
  EXPECT_EQ(sample(), BusError::none);
}

TEST_F(FtdiLinkTest, NoAnswerCountsAsAFailure) {
  drivers::Pca9685 absent(0x41);
  absent.all_off(link);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(absent.status(), BusError::nak);
  drivers::Mpu6050 imu;
  imu.configure(link);
  ASSERT_EQ(link.run(), BusError::none);
  drivers::InertialSample<float> values{};
  emulator().faults().force(Fault::nak);
  imu.request(link);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(imu.sample(values), BusError::nak);
  imu.request(link);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(imu.sample(values), BusError::none);
}

TEST_F(FtdiLinkTest, AThousandBytesThatAreNotAcknowledged) {
  drivers::Mpu6050 imu;
  imu.configure(link);
  ASSERT_EQ(link.run(), BusError::none);
  drivers::InertialSample<float> values{};
  for (int i = 0; i < 1000; ++i) {
    emulator().faults().force(Fault::nak);
    imu.request(link);
    ASSERT_EQ(link.run(), BusError::none);
    ASSERT_EQ(imu.sample(values), BusError::nak);
    imu.request(link);
    ASSERT_EQ(link.run(), BusError::none);
    ASSERT_EQ(imu.sample(values), BusError::none);
  }
}

TEST_F(FtdiLinkTest, AnswersThatAreCutMissingOrLate) {
  for (int i = 0; i < 50; ++i) {
    emulator().faults().force(Fault::cut);
    EXPECT_EQ(sample(), BusError::short_reply);
    EXPECT_EQ(sample(), BusError::none);
    emulator().faults().force(Fault::silent);
    EXPECT_EQ(sample(), BusError::timeout);
    EXPECT_EQ(sample(), BusError::none);
    emulator().faults().force(Fault::late);
    EXPECT_EQ(sample(), BusError::timeout);
    counts = 0;
    EXPECT_EQ(sample(), BusError::none) << "what came too late is not taken for the answer";
    EXPECT_NEAR(counts, 8192, 800);
  }
  EXPECT_EQ(link.counts().resyncs, 150U);
  EXPECT_EQ(link.counts().lost, 0U);
}

TEST_F(FtdiLinkTest, HarmlessDelays) {
  for (int i = 0; i < 50; ++i) {
    emulator().faults().force(i % 2 == 0 ? Fault::split : Fault::spike);
    EXPECT_EQ(sample(), BusError::none);
  }
}

TEST_F(FtdiLinkTest, WrongBitsAndStuckLines) {
  for (int i = 0; i < 50; ++i) {
    emulator().faults().force(Fault::corrupt);
    EXPECT_EQ(sample(), BusError::parity);
    emulator().faults().force(Fault::stuck_low);
    EXPECT_EQ(sample(), BusError::not_ready);
    emulator().faults().force(Fault::stuck_high);
    EXPECT_EQ(sample(), BusError::refused);
    EXPECT_EQ(sample(), BusError::none);
  }
}

TEST_F(FtdiLinkTest, PulledOutAndBack) {
  for (int i = 0; i < 20; ++i) {
    emulator().faults().force(Fault::unplug);
    EXPECT_EQ(sample(), BusError::link_lost);
    EXPECT_FALSE(link.is_open());
    int tries = 0;
    while (sample() != BusError::none) {
      ASSERT_LT(++tries, 100);
      emulator().time().pass(10 * emulated::kNsPerMs);
    }
  }
  EXPECT_EQ(link.counts().lost, 20U);
  EXPECT_EQ(link.counts().reconnects, 20U);
}

TEST(FtdiUart, Servo) {
  FtdiUart line;
  emulator().time().pass(emulated::kNsPerSecond);
  ASSERT_TRUE(line.open(kAny, 57'600, kTimeoutMs));
  const drivers::DynamixelX servo(1);
  const auto goal = servo.write(drivers::DynamixelX::kGoalPosition, 0xfffdffffU, 4);
  ASSERT_EQ(line.write(goal.data(), goal.size()), BusError::none);
  std::uint8_t answer[11]{};
  ASSERT_EQ(line.read(answer, sizeof answer), BusError::none);
  EXPECT_EQ(drivers::dynamixel_status(answer, sizeof answer, 1, nullptr, 0), BusError::none);
  std::int32_t position = 0;
  EXPECT_EQ(servo.position(line, position), BusError::none);
  EXPECT_EQ(position, -131'073);
  EXPECT_EQ(line.read(answer, 1), BusError::timeout);
  emulator().pull_out(emulated::kNsPerMs);
  EXPECT_EQ(servo.position(line, position), BusError::link_lost);
  EXPECT_FALSE(line.is_open());
  emulator().time().pass(emulated::kNsPerSecond);
  EXPECT_EQ(servo.position(line, position), BusError::none) << "it is back";
  line.close();
}

}  // namespace
}  // namespace eagerx::links

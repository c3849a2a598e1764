// Every peripheral of the STM32F405 against registers that behave as RM0090 says.
#include <gtest/gtest.h>

#include <eagerx/peripheral.hpp>
#include <models/drivers/dynamixel/dynamixel.hpp>
#include <models/drivers/mpu6050/mpu6050.hpp>
#include <models/links/immediate_link.hpp>
#include <targets/common/bare-metal/uart_line.hpp>
#include <targets/emulated-ftdi/bench_devices.hpp>
#include <targets/stm32f405/adc.hpp>
#include <targets/stm32f405/encoder.hpp>
#include <targets/stm32f405/i2c.hpp>
#include <targets/stm32f405/pwm.hpp>
#include <targets/stm32f405/timer.hpp>
#include <targets/stm32f405/uart.hpp>
#include <targets/stm32f405/watchdog.hpp>

#include "tests/unit/stm32f405/fake_chip.hpp"

namespace eagerx::board::stm32::testing {
namespace {

using board::testing::FakeChip;
using board::testing::FakeMemory;
using board::testing::FakeTime;
using Write = FakeChip::Write;

class Stm32 : public ::testing::Test {
 protected:
  Stm32() { FakeMemory::chip = &chip; }

  FakeChip chip;
};

TEST(PinNames, AreReadStrictly) {
  EXPECT_EQ(pin_of("PA9"), (Pin{0, 9}));
  EXPECT_EQ(pin_of("PI15"), (Pin{8, 15}));
  for (const char* wrong : {"", "P", "PA", "A9", "PJ1", "PA16", "PA09", "PA-1", "pa9", "PA9 "})
    EXPECT_EQ(pin_of(wrong), kNoPin) << wrong;
}

TEST_F(Stm32, AnOutputHasItsLevelBeforeItIsOne) {
  Gpio<FakeMemory>::make_output(pin_of("PB3"), true);
  const std::vector<Write> expected = {{0x40023830, 1U << 1U},   // clock of port B
                                       {0x40020418, 1U << 3U},   // set
                                       {0x40020400, 1U << 6U}};  // output
  EXPECT_EQ(chip.writes, expected);
}

TEST_F(Stm32, APinIsGivenToAPeripheral) {
  Gpio<FakeMemory>::make_alternate(pin_of("PA10"), 7, PinPull::up);
  EXPECT_EQ(chip.at[0x40020024], 7U << 8U);   // function
  EXPECT_EQ(chip.at[0x40020000], 2U << 20U);  // alternate
  EXPECT_EQ(chip.at[0x4002000c], 1U << 20U);  // pull-up
}

TEST_F(Stm32, SerialLine) {
  const Uart<FakeMemory> uart(kUsart1);
  EXPECT_FALSE(uart.start(pin_of("PA9"), kNoPin, 115'200));
  EXPECT_FALSE(uart.start(pin_of("PA9"), pin_of("PA10"), 6'000'000));
  ASSERT_TRUE(uart.start(pin_of("PA9"), pin_of("PA10"), 115'200));
  EXPECT_EQ(chip.at[0x40011008], 729U);  // 84 MHz / 115200, 30.3.4
  EXPECT_EQ(chip.at[0x4001100c], 0x200cU);
  EXPECT_TRUE(uart.put('x'));
  EXPECT_EQ(chip.serial_out, "x");
  std::uint8_t byte = 0;
  BusError error = BusError::none;
  EXPECT_FALSE(uart.take(byte, error));
  for (const auto& [flag, expected] : {std::pair{0U, BusError::none},
                                       {2U, BusError::frame},
                                       {4U, BusError::frame},
                                       {8U, BusError::short_reply}}) {
    chip.serial_in = "y";
    chip.serial_errors = flag;
    ASSERT_TRUE(uart.take(byte, error));
    EXPECT_EQ(byte, 'y');
    EXPECT_EQ(error, expected);
  }
}

/// A clock on which every look takes a microsecond.
struct PollTime {
  static inline std::int64_t now = 0;
  static std::int64_t now_ns() { return now += 1000; }
};

TEST_F(Stm32, AServoAnswersOverTheSerialLine) {
  const Uart<FakeMemory> uart(kUsart1);
  ASSERT_TRUE(uart.start(pin_of("PA9"), pin_of("PA10"), 1'000'000));
  UartLine<Uart<FakeMemory>, PollTime> line(uart, 1'000'000);
  static_assert(UartBus<decltype(line)>);
  const drivers::DynamixelX servo(1);
  // The status packet of the e-Manual's example for reading: position 166.
  chip.serial_answer =
      std::string("\xff\xff\xfd\x00\x01\x08\x00\x55\x00\xa6\x00\x00\x00\x8c\xc0", 15);
  chip.serial_question = servo.read(drivers::DynamixelX::kPresentPosition, 4).size();
  chip.serial_in = "an answer that was too late";
  std::int32_t counts = 0;
  EXPECT_EQ(servo.position(line, counts), BusError::none);
  EXPECT_EQ(counts, 166);
  const auto request = servo.read(drivers::DynamixelX::kPresentPosition, 4);
  EXPECT_EQ(chip.serial_out,
            std::string(reinterpret_cast<const char*>(request.data()), request.size()));
  EXPECT_EQ(servo.position(line, counts), BusError::timeout);
  chip.serial_in = "noise";
  line.flush();
  EXPECT_TRUE(chip.serial_in.empty());
}

TEST_F(Stm32, PwmHasItsFrequencyAndDuty) {
  Pwm<FakeMemory> pwm;
  EXPECT_EQ(pwm.write_duty(0, 0.5F), BusError::unsupported);
  EXPECT_FALSE(pwm.start(kTimer3, 0));
  ASSERT_TRUE(pwm.start(kTimer3, 20'000));
  ASSERT_TRUE(pwm.add(2));
  EXPECT_EQ(chip.at[0x40000428], 0U);          // prescaler
  EXPECT_EQ(chip.at[0x4000042c], 4200U - 1U);  // 84 MHz / 20 kHz
  EXPECT_EQ(chip.at[0x4000041c], 0x68U);       // channel 3: PWM mode 1, preload
  EXPECT_EQ(chip.at[0x40000420], 1U << 8U);    // its output
  EXPECT_EQ(chip.at[0x40020400], 2U << 0U);    // PB0 alternate
  for (const auto& [duty, counts] : {std::pair{0.5F, 2100U},
                                     {1.0F, 4200U},
                                     {7.0F, 4200U},
                                     {-1.0F, 0U},
                                     {0.0001F, 0U},
                                     {0.0002F, 1U}}) {
    EXPECT_EQ(pwm.write_duty(2, duty), BusError::none);
    EXPECT_EQ(chip.at[0x4000043c], counts) << duty;
  }
  EXPECT_EQ(pwm.write_duty(4, 0.5F), BusError::unsupported);
}

TEST_F(Stm32, PwmDividesForLowFrequencies) {
  Pwm<FakeMemory> pwm;
  ASSERT_TRUE(pwm.start(kTimer1, 50));
  EXPECT_EQ(chip.at[0x40010028], 51U);  // 168 MHz / 52 / 64615 = 50.0005 Hz
  EXPECT_EQ(chip.at[0x4001002c], 64'615U - 1U);
  EXPECT_EQ(chip.at[0x40010044], 1U << 15U);  // an advanced timer's main output
}

TEST_F(Stm32, PwmOfAllTimersStops) {
  Pwm<FakeMemory> general;
  Pwm<FakeMemory> advanced;
  ASSERT_TRUE(general.start(kTimer3, 20'000) && general.add(2));
  ASSERT_TRUE(advanced.start(kTimer8, 20'000) && advanced.add(0));
  stop_all_pwm<FakeMemory>();
  EXPECT_EQ(chip.at[0x40000420], 0U);
  EXPECT_EQ(chip.at[0x40010420], 0U);
  EXPECT_EQ(chip.at[0x40010444], 0U);  // the main output of TIM8
}

TEST_F(Stm32, EncoderCountsBeyondSixteenBits) {
  Encoder<FakeMemory> encoder;
  std::int32_t counts = 0;
  EXPECT_EQ(encoder.read(counts), BusError::unsupported);
  encoder.start(kTimer4);
  EXPECT_EQ(chip.at[0x40000808], 3U);       // both edges
  EXPECT_EQ(chip.at[0x40000818], 0x3131U);  // own inputs, filter 3
  EXPECT_EQ(chip.at[0x4000082c], 0xffffU);
  EXPECT_EQ(chip.at[0x40000800], 1U);
  std::int32_t expected = 0;
  for (const std::int32_t step : {30'000, 30'000, 30'000, -1, -32'768, -30'000, -30'000, 32'767}) {
    expected += step;
    chip.at[0x40000824] = static_cast<std::uint32_t>(expected) & 0xffffU;
    ASSERT_EQ(encoder.read(counts), BusError::none);
    EXPECT_EQ(counts, expected);
  }
}

TEST_F(Stm32, TimerGoesBeyondThirtyTwoBits) {
  Timer<FakeMemory> timer;
  EXPECT_FALSE(timer.start(kTimer3));
  ASSERT_TRUE(timer.start(kTimer2));
  EXPECT_EQ(timer.hz(), 84'000'000U);
  std::uint64_t expected = 0;
  for (const std::uint64_t step : {5ULL, 0xffff'fff0ULL, 0x100ULL, 0xffff'ffffULL}) {
    expected += step;
    chip.at[0x40000024] = static_cast<std::uint32_t>(expected);
    EXPECT_EQ(timer.ticks(), expected);
  }
}

TEST_F(Stm32, AdcConvertsOneChannelAtATime) {
  Adc<FakeMemory> adc;
  float volts = 0.0F;
  EXPECT_EQ(adc.read_volts(0, volts), BusError::unsupported);
  adc.start(3.3F);
  ASSERT_TRUE(adc.add(11));
  EXPECT_FALSE(adc.add(16));
  EXPECT_EQ(chip.at[0x40020800], 3U << 2U);  // PC1 analogue
  EXPECT_EQ(chip.at[0x40012304], 1U << 16U);
  EXPECT_EQ(chip.at[0x40012010], 0x1b6db6dbU);
  chip.analog[11] = 2048;
  ASSERT_EQ(adc.read_volts(11, volts), BusError::none);
  EXPECT_FLOAT_EQ(volts, 1.65F);
  chip.is_silent = true;
  EXPECT_EQ(adc.read_volts(11, volts), BusError::timeout);
  EXPECT_EQ(adc.read_volts(16, volts), BusError::unsupported);
}

TEST_F(Stm32, WatchdogStartsInTheOrderOfTheManual) {
  EXPECT_FALSE(IndependentWatchdog<FakeMemory>::start(0));
  EXPECT_FALSE(IndependentWatchdog<FakeMemory>::start(32'769));
  EXPECT_TRUE(chip.writes.empty());
  ASSERT_TRUE(IndependentWatchdog<FakeMemory>::start(100));
  const std::vector<Write> expected = {{0x40003000, 0xcccc},
                                       {0x40003000, 0x5555},
                                       {0x40003004, 0},        // 32 kHz / 4
                                       {0x40003008, 800 - 1},  // 100 ms
                                       {0x40003000, 0xaaaa}};
  EXPECT_EQ(chip.writes, expected);
  ASSERT_TRUE(IndependentWatchdog<FakeMemory>::start(32'768));
  EXPECT_EQ(chip.at[0x40003004], 6U);
  EXPECT_EQ(chip.at[0x40003008], 4095U);
}

// I2C: the MPU-6050's driver through the registers.

using I2c1 = I2c<FakeTime, FakeMemory>;
constexpr I2cPins kI2cLines{pin_of("PB6"), pin_of("PB7")};

TEST_F(Stm32, I2cClocksOfTheManual) {
  I2c1 bus;
  EXPECT_FALSE(bus.start(kI2c1, {pin_of("PB6"), pin_of("PA7")}, 400'000));
  ASSERT_TRUE(bus.start(kI2c1, kI2cLines, 400'000));
  std::uint8_t byte = 0;
  EXPECT_EQ(bus.transfer({0x68, 100'000}, &byte, 1, nullptr, 0), BusError::nak);
  EXPECT_EQ(chip.at[0x40005404], 42U);   // MHz
  EXPECT_EQ(chip.at[0x4000541c], 210U);  // 100 kHz
  EXPECT_EQ(chip.at[0x40005420], 43U);   // 1 us
  EXPECT_EQ(bus.transfer({0x68, 400'000}, &byte, 1, nullptr, 0), BusError::nak);
  EXPECT_EQ(chip.at[0x4000541c], 0x8000U + 35U);  // 400 kHz
  EXPECT_EQ(chip.at[0x40005420], 13U);
  EXPECT_EQ(bus.transfer({0x68, 50'000}, &byte, 1, nullptr, 0), BusError::unsupported);
}

TEST_F(Stm32, I2cReadsAnyNumberOfBytesAndNotOneMore) {
  emulated::Imu imu;
  for (std::uint8_t i = 0; i < 9; ++i) imu.set(i, static_cast<std::uint8_t>(i + 10));
  chip.wire(imu);
  I2c1 bus;
  ASSERT_TRUE(bus.start(kI2c1, kI2cLines, 400'000));
  for (std::size_t n = 1; n <= 9; ++n) {
    const std::uint8_t reg = 0;
    std::uint8_t in[9]{};
    chip.i2c_bytes_read = 0;
    ASSERT_EQ(bus.transfer({0x68, 400'000}, &reg, 1, in, n), BusError::none) << n;
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(in[i], i + 10) << n;
    EXPECT_EQ(chip.i2c_bytes_read, n);
    EXPECT_TRUE(chip.i2c_last_not_acknowledged) << n;
  }
}

/// As much of a chip as the driver of an I2C device needs.
struct I2cOnly {
  I2c1 bus;
  BusError i2c(I2cDevice device, const std::uint8_t* out, std::size_t n, std::uint8_t* in,
               std::size_t m) {
    return bus.transfer(device, out, n, in, m);
  }
};

TEST_F(Stm32, ADriverWorksOverTheRegisters) {
  emulated::Imu imu;
  chip.wire(imu);
  links::ImmediateLink<I2cOnly, FakeTime> link;
  ASSERT_TRUE(link.hardware().bus.start(kI2c1, kI2cLines, 400'000));
  drivers::Mpu6050 driver;
  driver.configure(link);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(driver.configured(), BusError::none);
  EXPECT_EQ(imu.get(0x6b), 1);
  imu.set(0x3f, 0x40);  // z: 1 g
  driver.request(link);
  ASSERT_EQ(link.run(), BusError::none);
  drivers::InertialSample<float> sample{};
  ASSERT_EQ(driver.sample(sample), BusError::none);
  EXPECT_FLOAT_EQ(sample.acceleration[2], 9.80665F);
}

TEST_F(Stm32, I2cFreesALineThatIsHeld) {
  emulated::Imu imu;
  chip.wire(imu);
  I2c1 bus;
  ASSERT_TRUE(bus.start(kI2c1, kI2cLines, 400'000));
  chip.holds_sda = true;
  chip.scl_pulses = 0;
  const std::uint8_t reg = 0x75;
  std::uint8_t in = 0;
  EXPECT_EQ(bus.transfer({0x68, 400'000}, &reg, 1, &in, 1), BusError::timeout);
  EXPECT_GE(chip.scl_pulses, 5);
  EXPECT_EQ(bus.transfer({0x68, 400'000}, &reg, 1, &in, 1), BusError::none);
  EXPECT_EQ(in, 0x68);
}

}  // namespace
}  // namespace eagerx::board::stm32::testing

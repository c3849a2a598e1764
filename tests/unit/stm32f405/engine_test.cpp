// The engine of the STM32F405: the pendulum's drivers, engine and safety through its registers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <eagerx/rate.hpp>
#include <models/objects/dc_motor/dc_motor_real.hpp>
#include <models/objects/pendulum/pendulum_real.hpp>
#include <numbers>
#include <string>
#include <targets/emulated-ftdi/pendulum_rig.hpp>
#include <targets/stm32f405/engine/engine.hpp>

#include "tests/unit/stm32f405/fake_chip.hpp"

// The board's own clock, which nothing here uses.
void eagerx::board::start_clock() {}
std::uint64_t eagerx::board::clock_ticks() {
  return 0;
}
void eagerx::board::wait_for_clock(std::uint64_t /*ticks*/) {}
std::uint64_t eagerx::board::clock_hz() {
  return 1;
}

namespace eagerx::board::stm32::testing {
namespace {

using board::testing::FakeChip;
using board::testing::FakeMemory;
using board::testing::FakeTime;

struct NoStates {};
struct EngineIo {
  using Real = float;
  using Rate = eagerx::Rate<100>;
  using States = NoStates;
  struct Config {
    static constexpr auto spi = SpiChoice::spi1;
    static constexpr const char* spi_pins = "PA5 PA6 PA7";
    static constexpr const char* selects = "PA4 PA2";
    static constexpr auto i2c = I2cChoice::none;
    static constexpr const char* i2c_pins = "PB6 PB7";
    static constexpr int max_hz = 10'000'000;
    static constexpr const char* pins = "PC13";
    static constexpr int pwm = 3;
    static constexpr int pwm_hz = 20'000;
    static constexpr int pwm_channels = 2;
    static constexpr std::array<int, 1> adc = {11};
    static constexpr double adc_reference = 3.3;
    static constexpr std::array<int, 1> encoders = {4};
    static constexpr int watchdog = 100;
    static constexpr double max_lateness = 0.0;
    static constexpr int late = 1;
    static constexpr int missed = 2;
    static constexpr int recover = 3;
  };
};
using FakeHardware = Hardware<FakeTime, FakeMemory>;
using FakeLink = links::ImmediateLink<FakeHardware, FakeTime>;
using FakeEngine = models::HardwareEngine<EngineIo, FakeLink,
                                          EnginePlatform<EngineIo::Config, FakeTime, FakeMemory>>;
using Simulator = models::HardwareSimulator<models::PendulumReal<EngineIo>, FakeLink>;

class Stm32Engine : public ::testing::Test {
 protected:
  Stm32Engine() {
    FakeMemory::chip = &chip;
    FakeTime::now = 1'000'000'000;
  }
  void wire() {
    chip.wire(4, encoder);
    chip.wire(2, converter);
  }
  void start() {
    engine.start(simulator);
    simulator.declare_safe(0, 0.0F);
    simulator.limit_sensor(0, -999.0F, 999.0F);
    engine.reset({}, simulator);
  }
  void act(float volts) { simulator.act(0, volts, -2.0F, 2.0F); }
  std::uint64_t count(const std::string& name) const {
    std::uint64_t found = 0;
    const auto look = [&](const char* each, std::uint64_t value) {
      if (each == name) found += value;
    };
    engine.for_each_count(look);
    simulator.for_each_count(look);
    return found;
  }

  FakeChip chip;
  emulated::Pendulum pendulum;
  emulated::Encoder encoder{pendulum};
  emulated::Converter converter{pendulum};
  FakeEngine engine;
  Simulator simulator;
};

TEST_F(Stm32Engine, MeasuresAndActsThroughTheRegisters) {
  wire();
  start();
  constexpr double kCount = 2 * std::numbers::pi / 16384;
  for (Seq n = 1; n <= 300; ++n) {
    act(n % 100 < 50 ? 1.5F : -1.5F);
    engine.callback(Tick{n}, simulator);
    ASSERT_FALSE(engine.is_safe()) << n;
    const double error = std::remainder(static_cast<double>(simulator.value(0)) - pendulum.theta(),
                                        2 * std::numbers::pi);
    ASSERT_LE(std::abs(error), kCount) << n;
    // One step later it is the command of the previous instant.
    ASSERT_NEAR(pendulum.voltage(), n % 100 < 50 ? 1.5 : -1.5, 0.0011) << n;
  }
  EXPECT_GT(encoder.samples(), 300U);
  EXPECT_EQ(count("sensor parity") + count("sensor not ready") + count("safe actions"), 0U);
  // Mode 0, master, 84 MHz / 16: the fastest up to 10 MHz.
  EXPECT_EQ(chip.last_spi_control & 0x3fU, (3U << 3U) | 4U | 1U);
  engine.stop(simulator);
  EXPECT_EQ(pendulum.voltage(), 0.0);
}

TEST_F(Stm32Engine, WithoutAnEncoderTheActionIsSafe) {
  chip.wire(2, converter);
  start();
  for (Seq n = 1; n <= 20; ++n) {
    act(1.5F);
    engine.callback(Tick{n}, simulator);
    EXPECT_TRUE(engine.is_safe());
    EXPECT_EQ(pendulum.voltage(), 0.0);
  }
  EXPECT_EQ(count("sensor not ready"), 21U);  // a line that reads 0 has the right parity
  EXPECT_EQ(count("instants with safe actions"), 20U);
}

TEST_F(Stm32Engine, ADeadSpiIsATimeOut) {
  wire();
  start();
  chip.is_silent = true;
  engine.callback(Tick{1}, simulator);
  EXPECT_TRUE(engine.is_safe());
  EXPECT_GT(count("bus timeouts"), 0U);
  chip.is_silent = false;
  for (Seq n = 2; n <= 10; ++n) engine.callback(Tick{n}, simulator);
  EXPECT_FALSE(engine.is_safe());
}

TEST_F(Stm32Engine, EveryMeasurementFeedsTheWatchdog) {
  wire();
  start();
  const auto feeds = [&] {
    std::size_t n = 0;
    for (const auto& write : chip.writes) n += write == FakeChip::Write{0x40003000, 0xaaaa};
    return n;
  };
  const std::size_t before = feeds();
  engine.callback(Tick{1}, simulator);
  EXPECT_GT(feeds(), before);
}

TEST_F(Stm32Engine, PinsPwmAdcAndEncodersByNumber) {
  FakeLink link;
  using Platform = EnginePlatform<EngineIo::Config, FakeTime, FakeMemory>;
  ASSERT_TRUE(Platform::open(link));
  bool level = false;
  float volts = 0.0F;
  std::int32_t counts = 0;
  chip.analog[11] = 1024;
  chip.at[0x40000824] = 0xfffe;
  chip.at[0x40020810] = 1U << 13U;
  link.read_pin(0, level);
  link.read_volts(0, volts);
  link.read_encoder(0, counts);
  link.write_duty(1, 0.25F);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_TRUE(level);
  EXPECT_FLOAT_EQ(volts, 0.825F);
  EXPECT_EQ(counts, -2);
  EXPECT_EQ(chip.at[0x40000438], 1050U);
  link.write_pin(0, true);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(chip.at[0x40020818], 1U << 13U);
  EXPECT_EQ(chip.at[0x40020800] >> 26U & 3U, 1U);  // an output now
  link.write_pin(1, true);
  EXPECT_EQ(link.run(), BusError::unsupported);
  EXPECT_EQ(link.run(), BusError::none);
}

struct MotorIo {
  using Real = float;
  struct Config {
    static constexpr int counts_per_turn = 2000;
    static constexpr double supply = 12.0;
    static constexpr double volts_per_ampere = 0.5;
  };
};

TEST_F(Stm32Engine, AMotorOnPwmEncoderAndAdc) {
  models::HardwareSimulator<models::DcMotorReal<MotorIo>, FakeLink> motor;
  chip.at[0x40000824] = 0;
  chip.analog[11] = 1241;  // 1 V
  engine.start(motor);
  motor.declare_safe(0, 0.0F);
  engine.reset({}, motor);
  motor.act(0, 3.0F, -12.0F, 12.0F);
  chip.at[0x40000824] = 500;  // a quarter of a turn in an instant
  engine.callback(Tick{1}, motor);
  ASSERT_FALSE(engine.is_safe());
  EXPECT_FLOAT_EQ(motor.value(0), std::numbers::pi_v<float> / 2);
  EXPECT_NEAR(motor.value(1), std::numbers::pi_v<float> / 2 * 100, 1e-3F);
  EXPECT_NEAR(motor.value(2), 2.0F, 1e-3F);
  EXPECT_EQ(chip.at[0x40000434], 1050U);  // 3 V of 12 V, of 4200 ticks
  EXPECT_EQ(chip.at[0x40000438], 0U);
  motor.act(0, -12.0F, -12.0F, 12.0F);
  chip.at[0x40000824] = 0xfe0c;  // back over zero
  engine.callback(Tick{2}, motor);
  EXPECT_FLOAT_EQ(motor.value(0), -std::numbers::pi_v<float> / 2);
  EXPECT_EQ(chip.at[0x40000434], 0U);
  EXPECT_EQ(chip.at[0x40000438], 4200U);
  engine.stop(motor);
  EXPECT_EQ(chip.at[0x40000438], 0U);
}

TEST_F(Stm32Engine, SpiKeepsToTheSlowerOfDeviceAndWiring) {
  Spi<FakeTime, FakeMemory> spi;
  std::uint32_t control = 0;
  ASSERT_TRUE(spi.start(kSpi1, {pin_of("PA5"), pin_of("PB4"), pin_of("PA7")}, 20'000'000));
  EXPECT_FALSE(spi.start(kSpi2, {pin_of("PA5"), pin_of("PB4"), pin_of("PA7")}, 20'000'000));
  for (const auto& [hz, divider] : {std::pair{84'000'000U, 2U},
                                    {20'000'000U, 2U},
                                    {10'000'000U, 3U},
                                    {1'000'000U, 6U},
                                    {328'125U, 7U}}) {
    ASSERT_TRUE(spi.control_of({0, 3, hz}, control)) << hz;
    EXPECT_EQ(control >> 3U & 7U, divider) << hz;
    EXPECT_EQ(control & 3U, 3U);
  }
  EXPECT_FALSE(spi.control_of({0, 0, 328'124}, control));
  EXPECT_FALSE(spi.control_of({0, 4, 1'000'000}, control));
}

}  // namespace
}  // namespace eagerx::board::stm32::testing

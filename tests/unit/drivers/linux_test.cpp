// Buses and pins of Linux: the kernel's structs against a kernel that answers as its headers say,
// numbers in files below a folder, and a pseudo terminal.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <models/drivers/as5048/as5048.hpp>
#include <models/drivers/dynamixel/dynamixel.hpp>
#include <models/drivers/mpu6050/mpu6050.hpp>
#include <models/engines/linux_engine/linux/hardware.hpp>
#include <models/engines/linux_engine/linux/linux_engine.hpp>
#include <models/links/immediate_link.hpp>
#include <models/links/linux/uart.hpp>
#include <string>
#include <thread>
#include <vector>

namespace eagerx::links::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Files are numbers from 100; what is asked of them is kept.
struct FakeKernel {
  static inline std::map<std::string, int> opened;
  static inline std::vector<int> closed;
  static inline std::uint32_t spi_mode, spi_hz;
  static inline std::vector<Bytes> sent;     // by SPI and I2C
  static inline std::vector<Bytes> answers;  // first in, first out
  static inline std::vector<unsigned> i2c_flags;
  static inline int fails = 0;  // error number of every request
  static inline gpio_v2_line_request line;
  static inline gpio_v2_line_config config;
  static inline std::uint64_t levels;
  static inline int seconds, feeds, options;

  static void begin() {
    opened.clear();
    closed.clear();
    sent.clear();
    answers.clear();
    i2c_flags.clear();
    fails = feeds = options = seconds = 0;
    levels = 0;
  }
  static int open(const char* path, int /*flags*/) {
    const std::string name = path;
    if (name.empty() || name.find("missing") != std::string::npos) return errno = ENOENT, -1;
    return opened[path] = 100 + static_cast<int>(opened.size());
  }
  static int close(int file) { return closed.push_back(file), 0; }
  static Bytes answer(std::size_t n) {
    Bytes bytes = answers.empty() ? Bytes{} : answers.front();
    if (!answers.empty()) answers.erase(answers.begin());
    bytes.resize(n);
    return bytes;
  }

  static int ioctl(int /*file*/, std::uintptr_t request, void* argument) {
    if (fails != 0) return errno = fails, -1;
    if (request == SPI_IOC_WR_MODE32) return spi_mode = *static_cast<std::uint32_t*>(argument), 0;
    if (request == SPI_IOC_MESSAGE(1)) return spi(*static_cast<spi_ioc_transfer*>(argument));
    if (request == I2C_RDWR) return i2c(*static_cast<i2c_rdwr_ioctl_data*>(argument));
    if (request == GPIO_V2_GET_LINE_IOCTL) {
      line = *static_cast<gpio_v2_line_request*>(argument);
      static_cast<gpio_v2_line_request*>(argument)->fd = 200;
    } else if (request == GPIO_V2_LINE_SET_CONFIG_IOCTL) {
      config = *static_cast<gpio_v2_line_config*>(argument);
    } else if (request == GPIO_V2_LINE_SET_VALUES_IOCTL) {
      levels = static_cast<gpio_v2_line_values*>(argument)->bits;
    } else if (request == GPIO_V2_LINE_GET_VALUES_IOCTL) {
      static_cast<gpio_v2_line_values*>(argument)->bits = levels;
    } else if (request == WDIOC_SETTIMEOUT) {
      seconds = *static_cast<int*>(argument);
    } else if (request == WDIOC_KEEPALIVE) {
      ++feeds;
    } else if (request == WDIOC_SETOPTIONS) {
      options = *static_cast<int*>(argument);
    } else {
      return errno = ENOTTY, -1;
    }
    return 0;
  }

 private:
  // NOLINTBEGIN(performance-no-int-to-ptr): the kernel takes addresses as numbers
  static int spi(const spi_ioc_transfer& transfer) {
    const auto* out = reinterpret_cast<const std::uint8_t*>(transfer.tx_buf);
    sent.emplace_back(out, out + transfer.len);
    spi_hz = transfer.speed_hz;
    const Bytes bytes = answer(transfer.len);
    if (transfer.rx_buf != 0)
      std::memcpy(reinterpret_cast<void*>(transfer.rx_buf), bytes.data(), bytes.size());
    return static_cast<int>(transfer.len);
  }
  // NOLINTEND(performance-no-int-to-ptr)
  static int i2c(const i2c_rdwr_ioctl_data& data) {
    for (unsigned i = 0; i < data.nmsgs; ++i) {
      const i2c_msg& message = data.msgs[i];
      i2c_flags.push_back(message.flags);
      if (message.flags == 0) {
        sent.emplace_back(message.buf, message.buf + message.len);
      } else {
        const Bytes bytes = answer(message.len);
        std::memcpy(message.buf, bytes.data(), bytes.size());
      }
    }
    return static_cast<int>(data.nmsgs);
  }
};

using Hardware = models::LinuxHardware<FakeKernel>;
using Link = ImmediateLink<Hardware, LinuxClock>;
static_assert(SpiBus<Link> && I2cBus<Link> && GpioBus<Link> && PwmBus<Link> && AdcBus<Link> &&
              EncoderBus<Link>);

class LinuxBuses : public ::testing::Test {
 protected:
  LinuxBuses() { FakeKernel::begin(); }

  Link link;
  Hardware& hardware = link.hardware();
};

TEST_F(LinuxBuses, AnEncoderOnSpi) {
  ASSERT_TRUE(hardware.add_spi("/dev/spidev0.0", 5'000'000));
  ASSERT_TRUE(hardware.add_spi("/dev/spidev0.1", 5'000'000));
  using Encoder = drivers::MagneticEncoder<drivers::As5048A>;
  Encoder encoder;
  const auto word = [](std::uint16_t data) {
    const std::uint16_t full = Encoder::with_parity(data);
    return Bytes{high_byte(full), low_byte(full)};
  };
  FakeKernel::answers = {word(0), word(1234), word(0x0180)};
  encoder.request(link, 1);
  ASSERT_EQ(link.run(), BusError::none);
  std::uint16_t counts = 0;
  EXPECT_EQ(encoder.angle(counts), BusError::none);
  EXPECT_EQ(counts, 1234);
  EXPECT_EQ(FakeKernel::spi_mode, 1U);
  EXPECT_EQ(FakeKernel::spi_hz, 5'000'000U);  // the wiring's, slower than the device's
  EXPECT_EQ(FakeKernel::sent.size(), 3U);     // a transfer a word: the line goes up in between
  encoder.request(link, 2);
  EXPECT_EQ(link.run(), BusError::unsupported);
}

TEST_F(LinuxBuses, AnInertialUnitOnI2c) {
  ASSERT_TRUE(hardware.open_i2c("/dev/i2c-1"));
  drivers::Mpu6050 driver;
  driver.configure(link);
  FakeKernel::answers = {};
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(driver.configured(), BusError::frame);  // the answer was 0
  EXPECT_EQ(FakeKernel::sent[0], (Bytes{0x6b, 0x01}));
  // Who am I: one request of two messages, which makes a repeated start.
  EXPECT_EQ(FakeKernel::i2c_flags, (std::vector<unsigned>{0, 0, 0, 0, 0, I2C_M_RD}));
  FakeKernel::answers = {{0, 0, 0, 0, 0x40, 0}};
  driver.request(link);
  ASSERT_EQ(link.run(), BusError::none);
  drivers::InertialSample<float> sample{};
  ASSERT_EQ(driver.sample(sample), BusError::none);
  EXPECT_FLOAT_EQ(sample.acceleration[2], 9.80665F);
}

TEST_F(LinuxBuses, ErrorNumbersAreNamed) {
  ASSERT_TRUE(hardware.open_i2c("/dev/i2c-1"));
  for (const auto& [number, expected, of_bus] :
       {std::tuple{ENXIO, BusError::nak, BusError::none},
        {EREMOTEIO, BusError::nak, BusError::none},
        {ETIMEDOUT, BusError::timeout, BusError::timeout},
        {EIO, BusError::link_lost, BusError::link_lost},
        {EOPNOTSUPP, BusError::unsupported, BusError::unsupported}}) {
    FakeKernel::fails = number;
    BusError status = BusError::none;
    const std::uint8_t byte = 0;
    link.i2c({0x68, 400'000}, &byte, 1, nullptr, 0, status);
    EXPECT_EQ(status, expected) << number;
    EXPECT_EQ(link.run(), of_bus) << number;
  }
}

TEST_F(LinuxBuses, WhatIsMissingIsAnErrorAndKeepsItsNumber) {
  EXPECT_FALSE(hardware.add_spi("/dev/missing", 1'000'000));
  ASSERT_TRUE(hardware.add_spi("/dev/spidev0.1", 1'000'000));
  const std::uint8_t byte = 7;
  link.spi({0, 0, 1'000'000}, &byte, nullptr, 1);
  link.spi({1, 0, 1'000'000}, &byte, nullptr, 1);  // is carried out all the same
  EXPECT_EQ(link.run(), BusError::link_lost);
  EXPECT_EQ(FakeKernel::sent, (std::vector<Bytes>{{7}}));
  EXPECT_FALSE(hardware.add_spi(std::string(300, 'x'), 1'000'000));
}

TEST_F(LinuxBuses, APinIsAnInputUntilItIsWritten) {
  ASSERT_TRUE(hardware.add_pin("/dev/gpiochip0", 17));
  EXPECT_EQ(FakeKernel::line.offsets[0], 17U);
  EXPECT_EQ(FakeKernel::line.config.flags, GPIO_V2_LINE_FLAG_INPUT);
  EXPECT_EQ(FakeKernel::closed, (std::vector<int>{100}));  // the chip; the line stays
  FakeKernel::levels = 1;
  bool level = false;
  link.read_pin(0, level);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_TRUE(level);
  link.write_pin(0, true);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(FakeKernel::config.flags, GPIO_V2_LINE_FLAG_OUTPUT);
  EXPECT_EQ(FakeKernel::config.attrs[0].attr.values, 1U);
  link.write_pin(0, false);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(FakeKernel::levels, 0U);
  link.write_pin(1, false);
  EXPECT_EQ(link.run(), BusError::unsupported);
  link.close();
  EXPECT_EQ(FakeKernel::closed.back(), 200);
}

TEST_F(LinuxBuses, EveryRunFeedsTheWatchdogAndTheEndStopsIt) {
  EXPECT_FALSE(hardware.open_watchdog("/dev/missing", 1000));
  ASSERT_TRUE(hardware.open_watchdog("/dev/watchdog", 1500));
  EXPECT_EQ(FakeKernel::seconds, 2);
  const int before = FakeKernel::feeds;
  link.run();
  EXPECT_EQ(FakeKernel::feeds, before + 1);
  link.close();
  EXPECT_EQ(FakeKernel::options, WDIOS_DISABLECARD);
}

/// Files with numbers in a folder of their own.
class LinuxNumbers : public LinuxBuses {
 protected:
  LinuxNumbers() {
    char name[] = "/tmp/eagerx-sysfs-XXXXXX";
    root = mkdtemp(name);
  }
  ~LinuxNumbers() override { std::filesystem::remove_all(root); }
  void put(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((root / name).parent_path());
    std::ofstream(root / name) << text;
  }
  long get(const std::string& name) const {
    std::ifstream file(root / name);
    long value = -1;
    file >> value;
    return value;
  }

  std::filesystem::path root;
};

TEST_F(LinuxNumbers, Pwm) {
  const std::string chip = root / "pwmchip0";
  for (const char* name : {"export", "pwm2/period", "pwm2/duty_cycle", "pwm2/enable"})
    put(std::string("pwmchip0/") + name, "77");
  EXPECT_FALSE(LinuxPwm().open(chip, 3, 20'000));
  EXPECT_FALSE(LinuxPwm().open(chip, 2, 0));
  ASSERT_TRUE(hardware.add_pwm(chip, 2, 20'000));
  EXPECT_EQ(get("pwmchip0/export"), 2);
  EXPECT_EQ(get("pwmchip0/pwm2/period"), 50'000);
  EXPECT_EQ(get("pwmchip0/pwm2/enable"), 1);
  link.write_duty(0, 0.25F);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(get("pwmchip0/pwm2/duty_cycle"), 12'500);
  link.write_duty(1, 0.25F);
  EXPECT_EQ(link.run(), BusError::unsupported);
}

TEST_F(LinuxNumbers, Voltages) {
  const std::string device = root;
  put("in_voltage3_raw", "1000\n");
  EXPECT_FALSE(hardware.add_adc(device, 3));  // without a scale it means nothing
  put("in_voltage_scale", "0.805664062\n");
  ASSERT_TRUE(hardware.add_adc(device, 3));
  float volts = 0.0F;
  link.read_volts(1, volts);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_FLOAT_EQ(volts, 0.805664062F);
  put("in_voltage3_raw", "-20\n");
  link.read_volts(1, volts);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_FLOAT_EQ(volts, -0.0161132812F);
  put("in_voltage3_raw", "none\n");
  link.read_volts(1, volts);
  EXPECT_EQ(link.run(), BusError::frame);
}

TEST_F(LinuxNumbers, Encoders) {
  put("count0/count", "18446744073709551614\n");  // -2 in 64 bits
  EXPECT_FALSE(hardware.add_encoder((root / "count1").string()));
  ASSERT_TRUE(hardware.add_encoder((root / "count0").string()));
  std::int32_t counts = 0;
  link.read_encoder(1, counts);
  ASSERT_EQ(link.run(), BusError::none);
  EXPECT_EQ(counts, -2);
}

TEST(LinuxUart, AServoOnAPseudoTerminal) {
  const int host = posix_openpt(O_RDWR | O_NOCTTY);
  if (host < 0) GTEST_SKIP() << "this system has no pseudo-terminals";
  ASSERT_EQ(grantpt(host), 0);
  ASSERT_EQ(unlockpt(host), 0);
  LinuxUart line;
  EXPECT_FALSE(line.open("/dev/null", 115'200, 50));
  ASSERT_TRUE(line.open(ptsname(host), 1'000'000, 1000));
  constexpr char kAnswer[] = "\xff\xff\xfd\x00\x01\x08\x00\x55\x00\xa6\x00\x00\x00\x8c\xc0";
  const drivers::DynamixelX servo(1);
  const auto request = servo.read(drivers::DynamixelX::kPresentPosition, 4);
  // A servo: it receives the whole request, then answers with `bytes` bytes.
  const auto answers = [&](std::size_t bytes) {
    return std::thread([&, bytes] {
      std::string heard;
      char byte = 0;
      while (heard.size() < request.size() && read(host, &byte, 1) == 1) heard.push_back(byte);
      EXPECT_EQ(std::memcmp(heard.data(), request.data(), request.size()), 0);
      EXPECT_EQ(write(host, kAnswer, bytes), static_cast<ssize_t>(bytes));
    });
  };
  std::int32_t counts = 0;
  ASSERT_EQ(write(host, kAnswer, 5), 5);  // the end of an answer that was too late
  std::thread whole = answers(15);
  EXPECT_EQ(servo.position(line, counts), BusError::none);
  EXPECT_EQ(counts, 166);
  whole.join();
  std::thread none = answers(0);
  EXPECT_EQ(servo.position(line, counts), BusError::timeout);
  none.join();
  std::thread part = answers(5);
  EXPECT_EQ(servo.position(line, counts), BusError::short_reply);
  part.join();
  close(host);
  EXPECT_EQ(servo.position(line, counts), BusError::link_lost);
  EXPECT_FALSE(line.is_open());
}

}  // namespace
}  // namespace eagerx::links::testing

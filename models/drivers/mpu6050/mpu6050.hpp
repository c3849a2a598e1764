// An inertial measurement unit of InvenSense on I2C: MPU-6050.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::drivers {

/// Acceleration, angular velocity and temperature of one instant.
template <class Real>
struct InertialSample {
  Real acceleration[3];      // [m/s²], x, y, z of the chip
  Real angular_velocity[3];  // [rad/s]
  Real temperature;          // [°C]
};

/// Full scales: ±2·2^k g and ±250·2^k °/s.
enum class AccelerationRange : std::uint8_t { g2, g4, g8, g16 };
enum class GyroRange : std::uint8_t { dps250, dps500, dps1000, dps2000 };

/// I2C up to 400 kHz, registers of 8 bits, words with the high byte first.
/// Source: InvenSense MPU-6000/MPU-6050 product specification 3.4 and register map 4.2.
class Mpu6050 {
 public:
  static constexpr std::uint8_t kAddress = 0x68;  // 0x69 with AD0 high
  static constexpr std::uint8_t kIdentity = 0x68;
  static constexpr std::uint32_t kMaxHz = 400'000;

  explicit constexpr Mpu6050(std::uint8_t address = kAddress,
                             AccelerationRange acceleration = AccelerationRange::g2,
                             GyroRange gyro = GyroRange::dps250)
      : address_(address), acceleration_(acceleration), gyro_(gyro) {}

  /// Queues the transfers that wake the chip up and set ranges and filter (`filter` 0 to 6, 5 to
  /// 260 Hz).
  template <I2cBus Bus>
  void configure(Bus& bus, std::uint8_t filter = 3) {
    write(bus, kPowerManagement1, kClockOfGyroX, setup_[0]);
    write(bus, kConfig, filter & 0x07U, setup_[1]);
    write(bus, kGyroConfig, static_cast<std::uint8_t>(static_cast<unsigned>(gyro_) << 3U),
          setup_[2]);
    write(bus, kAccelerationConfig,
          static_cast<std::uint8_t>(static_cast<unsigned>(acceleration_) << 3U), setup_[3]);
    bus.i2c(device(), &kWhoAmI, 1, &identity_, 1, setup_[4]);
  }
  /// After run(): none if everything was acknowledged and this is the right chip.
  BusError configured() const {
    for (const BusError error : setup_) {
      if (error != BusError::none) return error;
    }
    return identity_ == kIdentity ? BusError::none : BusError::frame;
  }

  /// Queues the reading of all seven words of one instant.
  template <I2cBus Bus>
  void request(Bus& bus) {
    bus.i2c(device(), &kAccelerationX, 1, words_, sizeof words_, status_);
  }

  /// After run(): the sample. Errors: nak, not_ready (nothing but zeros: the chip sleeps, as it
  /// does after a loss of power, or the data line is stuck at 0, which also looks acknowledged).
  template <class Real>
  BusError sample(InertialSample<Real>& sample) const {
    if (status_ != BusError::none) return status_;
    unsigned any = 0;
    for (const std::uint8_t byte : words_) any |= byte;
    if (any == 0) return BusError::not_ready;
    constexpr auto kGravity = Real(9.80665);                       // [m/s²]
    constexpr auto kRadPerDegree = Real(0.017453292519943295769);  // π/180
    const Real per_g = Real(16384) / Real(1U << static_cast<unsigned>(acceleration_));
    // 131, 65.5, 32.8, 16.4 digits per °/s: the data sheet rounds 32.75 and 16.375 up.
    constexpr Real kPerDegree[] = {Real(131), Real(65.5), Real(32.8), Real(16.4)};
    const Real per_degree = kPerDegree[static_cast<std::size_t>(gyro_)];
    for (std::size_t i = 0; i < 3; ++i) {
      sample.acceleration[i] = word_at(i) / per_g * kGravity;
      sample.angular_velocity[i] = word_at(i + 4) / per_degree * kRadPerDegree;
    }
    sample.temperature = word_at(3) / Real(340) + Real(36.53);
    return BusError::none;
  }

 private:
  static constexpr std::uint8_t kConfig = 0x1a;
  static constexpr std::uint8_t kGyroConfig = 0x1b;
  static constexpr std::uint8_t kAccelerationConfig = 0x1c;
  static constexpr std::uint8_t kAccelerationX = 0x3b;  // ax, ay, az, temperature, gx, gy, gz
  static constexpr std::uint8_t kPowerManagement1 = 0x6b;
  static constexpr std::uint8_t kClockOfGyroX = 0x01;  // sleep bit off
  static constexpr std::uint8_t kWhoAmI = 0x75;

  I2cDevice device() const { return {address_, kMaxHz}; }
  template <class Bus>
  void write(Bus& bus, std::uint8_t reg, std::uint8_t value, BusError& status) {
    const std::uint8_t bytes[2] = {reg, value};
    bus.i2c(device(), bytes, 2, nullptr, 0, status);
  }
  std::int16_t word_at(std::size_t i) const { return signed_word(big_endian(words_ + 2 * i)); }

  std::uint8_t address_;
  AccelerationRange acceleration_;
  GyroRange gyro_;
  std::uint8_t words_[14]{};
  std::uint8_t identity_ = 0;
  BusError status_ = BusError::none;
  BusError setup_[5]{};
};

}  // namespace eagerx::drivers

// Devices for tests of the other drivers, each with only what its test needs.
#pragma once

#include <array>
#include <cstdint>
#include <models/drivers/dynamixel/dynamixel.hpp>
#include <targets/emulated-ftdi/devices.hpp>

namespace eagerx::emulated {

/// A MPU-6050 at rest, with z upwards: 1 g at the range of 2 g, once it is awake. Its registers can
/// be read and written.
class Imu final : public I2cSlave {
 public:
  Imu() : I2cSlave(0x68) {
    registers_[0x75] = 0x68;
    registers_[kPower] = kAsleep;
  }
  void set(std::uint8_t reg, std::uint8_t value) override { registers_[reg & 0x7fU] = value; }
  std::uint8_t get(std::uint8_t reg) override {
    constexpr std::uint8_t kHighByteOfZ = 0x3f;
    if (reg == kHighByteOfZ) return (registers_[kPower] & kAsleep) != 0 ? 0x00 : 0x40;
    return registers_[reg & 0x7fU];
  }

 private:
  static constexpr std::uint8_t kPower = 0x6b;   // PWR_MGMT_1
  static constexpr std::uint8_t kAsleep = 0x40;  // as after switching on
  std::array<std::uint8_t, 128> registers_{};
};

/// A PCA9685: 256 registers, the prescaler can be written while the chip sleeps only.
class Pwm final : public I2cSlave {
 public:
  Pwm() : I2cSlave(0x40) {
    registers_[0] = 0x11;
    registers_[0xfe] = 0x1e;
  }
  void set(std::uint8_t reg, std::uint8_t value) override {
    if (reg == 0xfe && (registers_[0] & 0x10U) == 0) return;
    registers_[reg] = value;
  }
  std::uint8_t get(std::uint8_t reg) override { return registers_[reg]; }

 private:
  std::array<std::uint8_t, 256> registers_{};
};

/// A servo of the X series with id 1 that answers reading and writing of four bytes.
class Servo final : public SerialSlave {
 public:
  std::size_t take(std::uint8_t byte, std::uint8_t* reply, std::size_t room) override {
    if (size_ == packet_.size()) size_ = 0;
    packet_[size_++] = byte;
    constexpr std::array<std::uint8_t, 4> kHeader = {0xff, 0xff, 0xfd, 0x00};
    if (size_ <= kHeader.size() && packet_[size_ - 1] != kHeader[size_ - 1]) size_ = 0;
    if (size_ < 7 || size_ < 7U + little_endian(packet_.data() + 5)) return 0;
    const std::size_t n = size_;
    size_ = 0;
    if (drivers::dynamixel_crc(packet_.data(), n - 2) != little_endian(packet_.data() + n - 2)) {
      return 0;
    }
    return answer(n, reply, room);
  }

 private:
  std::size_t answer(std::size_t n, std::uint8_t* reply, std::size_t room) {
    std::array<std::uint8_t, 5> status{};  // error, parameters
    std::size_t size = 1;
    const std::uint16_t address = little_endian(packet_.data() + 8);
    if (packet_[7] == drivers::DynamixelX::kRead && address < 256) {
      for (; size < 5; ++size) status[size] = table_[address + size - 1];
    } else if (packet_[7] == drivers::DynamixelX::kWrite && address < 256) {
      std::size_t to = address;
      for (std::size_t i = 10; i < n - 2; ++i) {
        table_[to++] = packet_[i];
        const bool header = packet_[i] == 0xfd && packet_[i - 1] == 0xff && packet_[i - 2] == 0xff;
        if (header) ++i;  // FD is sent twice then
      }
      if (address == drivers::DynamixelX::kGoalPosition) {  // a very fast servo
        for (std::size_t i = 0; i < 4; ++i) {
          table_[drivers::DynamixelX::kPresentPosition + i] = table_[address + i];
        }
      }
    } else {
      status[0] = 0x02;  // instruction error
    }
    drivers::DynamixelPacket<6> packet;
    packet.build(packet_[4], 0x55, status.data(), size);
    for (std::size_t i = 0; i < packet.size() && i < room; ++i) reply[i] = packet.data()[i];
    return packet.size() < room ? packet.size() : room;
  }

  std::array<std::uint8_t, 64> packet_{};
  std::array<std::uint8_t, 512> table_{};
  std::size_t size_ = 0;
};

}  // namespace eagerx::emulated

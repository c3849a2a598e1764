// Devices that can be wired to the adapter.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::emulated {

/// A device with a select line.
class SpiSlave {
 public:
  SpiSlave() = default;
  SpiSlave(const SpiSlave&) = delete;
  SpiSlave& operator=(const SpiSlave&) = delete;
  virtual ~SpiSlave() = default;

  virtual unsigned mode() const = 0;
  /// The select line falls or rises.
  virtual void select(std::int64_t now_ns) = 0;
  virtual void release(std::int64_t now_ns) = 0;
  /// Receives and sends a byte at the same time.
  virtual std::uint8_t exchange(std::uint8_t byte) = 0;
  virtual void power_lost() = 0;
};

/// A device with registers on I2C; the first byte written is the register's number, which counts
/// up.
class I2cSlave {
 public:
  explicit I2cSlave(std::uint8_t address) : address_(address) {}
  I2cSlave(const I2cSlave&) = delete;
  I2cSlave& operator=(const I2cSlave&) = delete;
  virtual ~I2cSlave() = default;

  std::uint8_t address() const { return address_; }
  void begin() { first_ = true; }
  void write(std::uint8_t byte) {
    if (first_) {
      register_ = byte;
    } else {
      set(register_++, byte);
    }
    first_ = false;
  }
  std::uint8_t read() { return get(register_++); }

  virtual void set(std::uint8_t reg, std::uint8_t value) = 0;
  virtual std::uint8_t get(std::uint8_t reg) = 0;

 private:
  std::uint8_t address_;
  std::uint8_t register_ = 0;
  bool first_ = true;
};

/// A device on a serial line: answers go to `reply`.
class SerialSlave {
 public:
  SerialSlave() = default;
  SerialSlave(const SerialSlave&) = delete;
  SerialSlave& operator=(const SerialSlave&) = delete;
  virtual ~SerialSlave() = default;

  /// Takes a byte; writes at most `room` bytes to `reply` and returns how many.
  virtual std::size_t take(std::uint8_t byte, std::uint8_t* reply, std::size_t room) = 0;
};

}  // namespace eagerx::emulated

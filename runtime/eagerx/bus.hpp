// Buses to sensors and actuators: the interface for drivers, independent of the transport.
//
// A bus takes transfers and carries them out in order when run() is called, so that one over USB
// needs one round trip for all of them; a board's own bus may carry each out at once. Buffers that
// a transfer fills are valid after run() and belong to the driver; those it sends are copied.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace eagerx {

/// The error of a transfer, or of a device's answer.
enum class BusError : std::uint8_t {
  none,
  // of the bus
  full,         // more transfers than one run() can hold; none of them was carried out
  unsupported,  // a mode, rate or pin that this bus does not have
  link_lost,    // the bus itself is gone, such as an unplugged adapter
  timeout,      // no answer in time
  short_reply,  // a part of the answer is missing
  nak,          // I2C: a byte was not acknowledged
  // of a device
  parity,        // parity bit wrong
  checksum,      // checksum wrong
  frame,         // the answer is no answer of this device
  refused,       // the device reports a wrong request
  not_ready,     // the device reports that it does not measure
  out_of_range,  // the device reports, or the driver finds, a value outside its range
};

constexpr const char* name_of(BusError error) {
  constexpr const char* kNames[] = {
      "none",   "full",     "unsupported", "link lost", "timeout",   "short reply", "nak",
      "parity", "checksum", "frame",       "refused",   "not ready", "out of range"};
  return kNames[static_cast<std::size_t>(error)];
}
inline constexpr std::size_t kBusErrors = static_cast<std::size_t>(BusError::out_of_range) + 1;

/// A device on an SPI bus, most significant bit first, select line low during transfers.
struct SpiDevice {
  std::uint8_t select;   // number of its select line
  std::uint8_t mode;     // 2·CPOL + CPHA
  std::uint32_t max_hz;  // fastest clock
};

/// A device on an I2C bus, with a 7-bit address.
struct I2cDevice {
  std::uint8_t address;
  std::uint32_t max_hz;
};

/// spi(device, out, in, n): sends n bytes and receives n at the same time; `in` may be null.
template <class B>
concept SpiBus = requires(B& bus, SpiDevice device, const std::uint8_t* out, std::uint8_t* in,
                          std::size_t n) {
  bus.spi(device, out, in, n);
  { bus.run() } -> std::same_as<BusError>;
};

/// i2c(device, out, n, in, m, status): writes n bytes, then, if m > 0, reads m after a repeated
/// start. After run(), `status` is none, or nak if a byte was not acknowledged.
template <class B>
concept I2cBus = requires(B& bus, I2cDevice device, const std::uint8_t* out, std::uint8_t* in,
                          std::size_t n, BusError& status) {
  bus.i2c(device, out, n, in, n, status);
  { bus.run() } -> std::same_as<BusError>;
};

/// write_pin(pin, level) and read_pin(pin, level&); `level` is valid after run().
template <class B>
concept GpioBus = requires(B& bus, std::uint8_t pin, bool level, bool& in) {
  bus.write_pin(pin, level);
  bus.read_pin(pin, in);
  { bus.run() } -> std::same_as<BusError>;
};

/// A serial line. write(out, n) sends; read(in, n) waits for n bytes, at most for the time-out with
/// which the line was opened.
template <class B>
concept UartBus = requires(B& bus, const std::uint8_t* out, std::uint8_t* in, std::size_t n) {
  { bus.write(out, n) } -> std::same_as<BusError>;
  { bus.read(in, n) } -> std::same_as<BusError>;
};

/// Bytes of a number, as sent over a wire.
constexpr std::uint8_t high_byte(std::uint16_t word) {
  return static_cast<std::uint8_t>(word >> 8U);
}
constexpr std::uint8_t low_byte(std::uint16_t word) {
  return static_cast<std::uint8_t>(word & 0xffU);
}
constexpr std::uint16_t big_endian(const std::uint8_t* bytes) {
  return static_cast<std::uint16_t>(bytes[0] << 8U | bytes[1]);
}
constexpr std::uint16_t little_endian(const std::uint8_t* bytes) {
  return static_cast<std::uint16_t>(bytes[1] << 8U | bytes[0]);
}
constexpr std::int16_t signed_word(std::uint16_t word) {
  return static_cast<std::int16_t>(word);
}

}  // namespace eagerx

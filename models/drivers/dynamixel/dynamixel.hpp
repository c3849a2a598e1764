// Servos of ROBOTIS on a serial line: DYNAMIXEL protocol 2.0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/bus.hpp>

namespace eagerx::drivers {

/// CRC-16 of a packet without its last two bytes: polynomial 0x8005, initial value 0, most
/// significant bit first. Source: ROBOTIS e-Manual, DYNAMIXEL protocol 2.0, "CRC calculation".
constexpr std::uint16_t dynamixel_crc(const std::uint8_t* bytes, std::size_t n) {
  unsigned crc = 0;
  for (std::size_t i = 0; i < n; ++i) {
    crc ^= static_cast<unsigned>(bytes[i]) << 8U;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 0x8000U) != 0 ? (crc << 1U ^ 0x8005U) & 0xffffU : crc << 1U & 0xffffU;
    }
  }
  return static_cast<std::uint16_t>(crc);
}

/// A packet: FF FF FD 00, id, length (2, low first), instruction, parameters, CRC (2, low first).
/// In the instruction and the parameters FD is sent twice after FF FF, so that the header is
/// unique.
template <std::size_t Parameters>
class DynamixelPacket {
 public:
  static constexpr std::size_t kHead = 7;
  // Every third parameter byte may need another one.
  static constexpr std::size_t kCapacity = kHead + 1 + Parameters + (Parameters + 1) / 3 + 2;

  /// Builds a packet with `n` parameters; nothing (size 0) if there are more than `Parameters`.
  constexpr void build(std::uint8_t id, std::uint8_t instruction, const std::uint8_t* parameters,
                       std::size_t n) {
    size_ = 0;
    if (n > Parameters) return;
    constexpr std::uint8_t kHeader[] = {0xff, 0xff, 0xfd, 0x00};
    for (const std::uint8_t byte : kHeader) bytes_[size_++] = byte;
    bytes_[size_++] = id;
    size_ = kHead;
    add(instruction);
    for (std::size_t i = 0; i < n; ++i) add(parameters[i]);
    const auto length = static_cast<std::uint16_t>(size_ - kHead + 2);
    bytes_[5] = low_byte(length);
    bytes_[6] = high_byte(length);
    const std::uint16_t crc = dynamixel_crc(bytes_, size_);
    bytes_[size_++] = low_byte(crc);
    bytes_[size_++] = high_byte(crc);
  }

  constexpr const std::uint8_t* data() const { return bytes_; }
  constexpr std::size_t size() const { return size_; }

 private:
  constexpr void add(std::uint8_t byte) {
    bytes_[size_++] = byte;
    const std::size_t body = size_ - kHead;
    if (body >= 3 && byte == 0xfd && bytes_[size_ - 2] == 0xff && bytes_[size_ - 3] == 0xff) {
      bytes_[size_++] = 0xfd;
    }
  }

  std::uint8_t bytes_[kCapacity]{};
  std::size_t size_ = 0;
};

/// Checks a status packet of `n` bytes from `id` and takes out its parameters: `count` of them go
/// to `parameters`. Errors: frame (no status of this servo, or another number of parameters),
/// checksum, refused (the servo reports an error; `alert`, bit 7, is not one).
inline BusError dynamixel_status(const std::uint8_t* packet, std::size_t n, std::uint8_t id,
                                 std::uint8_t* parameters, std::size_t count) {
  constexpr std::size_t kHead = 7;
  constexpr std::uint8_t kStatus = 0x55;
  if (n < kHead + 4) return BusError::frame;
  if (packet[0] != 0xff || packet[1] != 0xff || packet[2] != 0xfd || packet[3] != 0x00) {
    return BusError::frame;
  }
  if (std::size_t{little_endian(packet + 5)} + kHead != n) return BusError::frame;
  if (dynamixel_crc(packet, n - 2) != little_endian(packet + n - 2)) return BusError::checksum;
  if (packet[4] != id || packet[kHead] != kStatus) return BusError::frame;
  std::size_t taken = 0;
  for (std::size_t i = kHead + 2; i < n - 2; ++i) {
    if (taken == count) return BusError::frame;
    parameters[taken++] = packet[i];
    const bool stuffed = packet[i] == 0xfd && packet[i - 1] == 0xff && packet[i - 2] == 0xff;
    if (stuffed && i + 1 < n - 2 && packet[i + 1] == 0xfd) ++i;
  }
  if (taken != count) return BusError::frame;
  return (packet[kHead + 1] & 0x7fU) == 0 ? BusError::none : BusError::refused;
}

/// A servo with the control table of the X series (XL430, XM430 …), e-Manual.
class DynamixelX {
 public:
  static constexpr std::uint16_t kTorqueEnable = 64;
  static constexpr std::uint16_t kGoalPosition = 116;     // 4 bytes, 4096 counts a turn
  static constexpr std::uint16_t kPresentPosition = 132;  // 4 bytes, signed
  static constexpr std::uint8_t kPing = 0x01;
  static constexpr std::uint8_t kRead = 0x02;
  static constexpr std::uint8_t kWrite = 0x03;

  explicit constexpr DynamixelX(std::uint8_t id) : id_(id) {}

  constexpr DynamixelPacket<6> ping() const { return packet(kPing, nullptr, 0); }
  constexpr DynamixelPacket<6> read(std::uint16_t address, std::uint16_t bytes) const {
    const std::uint8_t parameters[] = {low_byte(address), high_byte(address), low_byte(bytes),
                                       high_byte(bytes)};
    return packet(kRead, parameters, sizeof parameters);
  }
  /// Writes the low `bytes` (1 to 4) bytes of `value`.
  constexpr DynamixelPacket<6> write(std::uint16_t address, std::uint32_t value,
                                     std::size_t bytes) const {
    const std::uint8_t parameters[] = {
        low_byte(address),
        high_byte(address),
        static_cast<std::uint8_t>(value & 0xffU),
        static_cast<std::uint8_t>(value >> 8U & 0xffU),
        static_cast<std::uint8_t>(value >> 16U & 0xffU),
        static_cast<std::uint8_t>(value >> 24U & 0xffU),
    };
    return packet(kWrite, parameters, 2 + (bytes < 4 ? bytes : 4));
  }

  /// Requests the position and waits for it, in counts. Errors: those of the line and of the status
  /// packet. On a line with flush(), discards earlier bytes, such as a late answer.
  template <UartBus Bus>
  BusError position(Bus& bus, std::int32_t& counts) const {
    constexpr std::size_t kHead = 7;
    constexpr std::size_t kShortest = 11;  // a status packet that only reports an error
    constexpr std::size_t kLongest = 16;   // a position such as -131073 holds FF FF FD, stuffed
    const auto request = read(kPresentPosition, 4);
    if constexpr (requires { bus.flush(); }) bus.flush();
    BusError error = bus.write(request.data(), request.size());
    if (error != BusError::none) return error;
    std::uint8_t answer[kLongest]{};
    error = bus.read(answer, kShortest);
    if (error != BusError::none) return error;
    const std::size_t n = kHead + std::size_t{little_endian(answer + 5)};
    if (n < kShortest || n > kLongest) return BusError::frame;
    if (n > kShortest) error = bus.read(answer + kShortest, n - kShortest);
    if (error != BusError::none) return error;
    if (n == kShortest) {
      error = dynamixel_status(answer, n, id_, nullptr, 0);
      return error != BusError::none ? error : BusError::frame;
    }
    std::uint8_t value[4]{};
    error = dynamixel_status(answer, n, id_, value, sizeof value);
    if (error != BusError::none) return error;
    counts =
        static_cast<std::int32_t>(std::uint32_t{value[0]} | std::uint32_t{value[1]} << 8U |
                                  std::uint32_t{value[2]} << 16U | std::uint32_t{value[3]} << 24U);
    return BusError::none;
  }

 private:
  constexpr DynamixelPacket<6> packet(std::uint8_t instruction, const std::uint8_t* parameters,
                                      std::size_t n) const {
    DynamixelPacket<6> packet;
    packet.build(id_, instruction, parameters, n);
    return packet;
  }

  std::uint8_t id_;
};

}  // namespace eagerx::drivers

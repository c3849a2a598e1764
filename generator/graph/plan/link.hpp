// Traffic of a serial link between the engine with its sensors and actuators, and the rest.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// A message that crosses, once however many read it.
struct LinkMessage {
  std::string name;        // "pendulum.theta", "actions.voltage", "smooth.filtered"
  bool to_engine = false;  // else from a sensor
  Rational rate_hz;
  std::uint64_t bytes = 0;  // of its elements
  Span span;                // where it is sent
  [[nodiscard]] Rational bytes_per_s() const {
    return rate_hz * Rational(static_cast<std::int64_t>(bytes));
  }
};

/// One direction. All messages of an instant go in one frame.
struct LinkLoad {
  Rational frames_per_s, bytes_per_s;  // without and with nothing but the elements
  std::uint64_t largest_frame = 0;     // bytes of elements
  Rational baud;                       // with framing
};

struct Link {
  std::vector<LinkMessage> messages;  // by name, sensors first
  LinkLoad sensors, actuators;
  /// The larger load of the two directions, each on its own wire.
  [[nodiscard]] const Rational& baud() const {
    return sensors.baud < actuators.baud ? actuators.baud : sensors.baud;
  }
};

/// Overhead of a frame in bytes in split programs (targets/README.md): two delimiters, COBS (one
/// more for every 254 bytes, not counted), kind, number, CRC-32C; and the bits of a byte with start
/// and stop bits.
inline constexpr std::int64_t kFrameBytes = 12;
inline constexpr std::int64_t kBitsOfByte = 10;

Link link_of(const Plan& plan);

}  // namespace eagerx::gen

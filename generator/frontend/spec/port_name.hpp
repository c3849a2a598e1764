// A port as connections write it.
#pragma once

#include <string>
#include <string_view>

namespace eagerx::gen {

/// `pendulum.theta`, or `pendulum.sensors.theta` with a section: "sensors", "inputs", "targets", …
struct PortName {
  std::string owner, section, name;

  /// The name after the owner: "theta", "sensors.theta".
  [[nodiscard]] std::string within_owner() const;
};

PortName parse_port(std::string_view text);

}  // namespace eagerx::gen

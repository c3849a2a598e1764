#include "generator/frontend/import/rebuilt.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace eagerx::gen {

std::string Rebuilt::match(const std::string& node) const {
  const auto found = matches.find(node);
  return found == matches.end() ? "" : found->second;
}

std::vector<std::string> Rebuilt::sensors(const std::string& node,
                                          const std::string& output) const {
  std::vector<std::string> result;
  const std::string port = fmt::format("{}.{}", node, output);
  for (const auto& connection : implementation->connections) {
    const PortName to = parse_port(connection.to.value);
    if (connection.from.value == port && to.owner == "sensors") result.push_back(to.name);
  }
  // std::ranges' answers with a view, which clang 14 does not compile with GCC 12's library.
  std::stable_partition(result.begin(), result.end(), [&](const std::string& sensor) {
    return object.is_selected("sensors", sensor);
  });
  return result;
}

const ConnectionSpec* Rebuilt::actuator(const std::string& node, const std::string& input) const {
  const std::string port = fmt::format("{}.{}", node, input);
  for (const auto& connection : implementation->connections) {
    if (connection.to.value == port && connection.from.value.starts_with("actuators."))
      return &connection;
  }
  return nullptr;
}

const ConnectionSpec* Rebuilt::inside(const std::string& from, const std::string& to) const {
  for (const auto& connection : implementation->connections) {
    if (connection.from.value == from && connection.to.value == to) return &connection;
  }
  return nullptr;
}

bool Rebuilt::has_node_of(std::string_view section, const std::string& port) const {
  const bool sensor = section == "sensors";
  for (const auto& connection : implementation->connections) {
    const PortName outside = parse_port(sensor ? connection.to.value : connection.from.value);
    if (outside.owner != section || outside.name != port) continue;
    const PortName inside = parse_port(sensor ? connection.from.value : connection.to.value);
    for (const auto& [in_file, local] : matches) {
      if (local == inside.owner) return true;
    }
  }
  return false;
}

}  // namespace eagerx::gen

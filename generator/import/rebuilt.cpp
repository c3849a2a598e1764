#include "generator/import/rebuilt.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace eagerx::gen {

std::pair<std::string, std::string> split_port(const std::string& port) {
  const std::size_t dot = port.find('.');
  return {port.substr(0, dot), dot == std::string::npos ? "" : port.substr(dot + 1)};
}

std::string Rebuilt::match(const std::string& node) const {
  const auto found = matches.find(node);
  return found == matches.end() ? "" : found->second;
}

std::vector<std::string> Rebuilt::sensors(const std::string& node,
                                          const std::string& output) const {
  std::vector<std::string> result;
  const std::string port = fmt::format("{}.{}", node, output);
  for (const auto& connection : implementation->connections) {
    const auto [section, name] = split_port(connection.to.value);
    if (connection.from.value == port && section == "sensors") result.push_back(name);
  }
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
    const auto [owner, name] = split_port(sensor ? connection.to.value : connection.from.value);
    if (owner != section || name != port) continue;
    const std::string node = split_port(sensor ? connection.from.value : connection.to.value).first;
    for (const auto& [in_file, local] : matches) {
      if (local == node) return true;
    }
  }
  return false;
}

}  // namespace eagerx::gen

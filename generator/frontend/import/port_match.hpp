// Finds the sensor or actuator of each engine node in a flattened file: EAGERx does not write it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/frontend/import/saved.hpp"

namespace eagerx::gen {

/// A port of an engine node, by the node's name within its object.
using InsidePort = std::pair<std::string, std::string>;

struct PortMatch {
  std::map<std::string, InsidePort> sensors, actuators;  // by the name that the object gives them
  std::vector<InsidePort> open;                          // used outside, but nothing tells what for
};

/// Matches by name, then by rate and space, then by elimination.
PortMatch match_ports(const SavedGraph& saved, const SavedObject& object,
                      const SavedEntity& backup);

}  // namespace eagerx::gen

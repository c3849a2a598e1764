// The ways that messages take from sensors to actuators.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generator/plan/hop.hpp"

namespace eagerx::gen {

/// All ways of one pair, each from the actuator's connection back to the sensor's.
struct Ways {
  std::vector<std::vector<const Hop*>> all;
  bool complete = true;  // false: there are more; the one with the least sum is among these
};

/// Ways by the names of sensor and actuator. Hops live as long as this.
class WayFinder {
 public:
  explicit WayFinder(const Plan& plan);
  using Pair = std::pair<std::string, std::string>;  // sensor, actuator
  [[nodiscard]] const std::map<Pair, Ways>& ways() const { return ways_; }
  /// Connections that a way may go over, but that are too slow or too long to say by how much data
  /// age on them. No way goes over them.
  [[nodiscard]] const std::vector<const Input*>& unknown() const { return unknown_; }

 private:
  void make_hops();
  void mark_behind_sensors();
  void walk(const std::string& actuator, const Hop& hop);
  void shortest(const std::string& actuator, const Hop& hop);
  void keep(const std::string& sensor, const std::string& actuator,
            const std::vector<const Hop*>& way, bool complete);
  [[nodiscard]] std::vector<const Hop*> behind(const Hop& hop) const;
  [[nodiscard]] const std::string& sensor_of(const Hop& hop) const;

  const Plan& plan_;
  std::vector<std::vector<Hop>> hops_;  // by node: those that its outputs come from
  std::vector<bool> reached_;           // nodes that data of a sensor reach
  std::vector<const Hop*> way_;
  std::vector<bool> on_way_;
  std::size_t steps_ = 0;
  std::map<Pair, Ways> ways_;
  std::vector<const Input*> unknown_;
};

}  // namespace eagerx::gen

// How old the data of a sensor are when they reach an actuator.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/plan/plan.hpp"

namespace eagerx::gen {

/// A connection on the way from a sensor to an actuator.
struct AgeHop {
  std::string input;  // where it leads: "observations.angle"
  Span span;
  Rational newest_s;  // most that the newest message is behind the tick that reads it
};

/// Data of a sensor at the ticks of an actuator, from the first tick on at which every window is
/// full and every delay has passed. A message is as old as the time since its sensor's tick. A way
/// goes through every node at most once: what a node remembers does not count. Of a delay that may
/// change the longest counts.
struct DataAge {
  std::string sensor, actuator;
  Rational newest_s;                 // of the freshest data in it, at the worst tick
  std::optional<Rational> oldest_s;  // of the oldest message in a window on any way
  bool exact = true;                 // false: no tick is worse, but perhaps none is as bad
  std::vector<AgeHop> way;           // the one with the least sum, from the sensor on
};

struct DataAges {
  std::vector<DataAge> known;
  std::vector<const Input*>
      unknown;  // connections that are left out: too slow, or too long a delay
};

/// For every sensor whose data reach an actuator, sorted by names. Where there are more ways or
/// longer hyperperiods than can be gone through, the ages are sums over connections.
DataAges data_ages(const Plan& plan);

}  // namespace eagerx::gen

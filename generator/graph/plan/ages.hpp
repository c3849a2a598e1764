// Age of sensor data at an actuator, and of an action in an observation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/graph/plan/paths.hpp"

namespace eagerx::gen {

/// A connection on a path.
struct AgeEdge {
  std::string input;  // where it leads: "observations.angle"
  Span span;
  Rational newest_s;  // most that the newest message is behind the tick that reads it
};

/// Data of one end at the ticks of the other, from the first tick on at which every window is full
/// and every delay has passed. A message is as old as the time since its sender's tick. A path
/// passes every node at most once: the memory of nodes does not count. For a variable delay, the
/// longest one counts. In a graph without an engine, a step takes an action and immediately returns
/// the next observation: the age is counted between calls, so it lacks one step.
struct DataAge {
  std::string from, to;              // a sensor and an actuator, or an action and an observation
  Rational newest_s;                 // of the freshest data in it, at the worst tick
  std::optional<Rational> oldest_s;  // of the oldest message in a window on any path
  bool exact = true;                 // false: no tick is worse, but perhaps none is as bad
  std::vector<AgeEdge> path;         // the one with the least sum, from its begin on
};

/// For every pair that data go between, sorted by names. Where there are more paths or longer
/// hyperperiods than can be gone through, the ages are sums over connections.
class DataAges {
 public:
  DataAges(const Plan& plan, const PathEnds& ends);
  [[nodiscard]] const std::vector<DataAge>& known() const { return known_; }
  /// As PathFinder::unknown_between().
  [[nodiscard]] std::vector<const Input*> unknown(const std::string& from = "",
                                                  const std::string& to = "") const {
    return finder_.unknown_between(from, to);
  }

 private:
  PathFinder finder_;
  std::vector<DataAge> known_;
};

}  // namespace eagerx::gen

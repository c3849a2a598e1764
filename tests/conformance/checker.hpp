// Compares a running program with a recording. The first difference ends the process.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "recording.hpp"

namespace eagerx::conformance {

/// What the program gave to a callback.
struct SeenWindow {
  std::string name;
  std::vector<std::uint64_t> seq;
  std::vector<double> sent_s;  // not rounded
  std::vector<double> values;
};

/// Where a comparison is.
struct Place {
  std::string node;
  std::uint64_t tick = 0;
};

class Checker {
 public:
  explicit Checker(Recording recording) : recording_(std::move(recording)) {}

  const Recording& recording() const { return recording_; }

  void begin_episode(std::uint32_t index);
  /// A callback is about to run; `time_s` is tick / rate, not rounded.
  void inputs(const Place& place, double time_s, const std::vector<SeenWindow>& windows);
  /// A message was published. The first of a node without inputs (the engine) also counts as its
  /// tick.
  void output(const Place& place, const std::string& port, const std::vector<double>& values);
  /// What the agent sees at a tick of the environment.
  void observation(std::uint64_t tick, const std::string& name, const std::vector<double>& values);
  /// Everything that was recorded up to the last tick of the environment must have happened.
  void end_episode(std::uint64_t steps);

  /// Prints what was compared and the largest deviations.
  void report() const;

 private:
  struct Deviation {
    double largest = 0.0;
    double tolerance = 0.0;
    std::uint32_t episode = 0;
    std::uint64_t tick = 0;
  };

  RecordedTick& recorded(const Place& place, std::string_view what);
  void compare_window(const Place& place, const RecordedWindow& expected, const SeenWindow& seen);
  void compare_values(const Place& place, const std::string& port, std::size_t line,
                      const std::vector<double>& expected, const std::vector<double>& seen);
  [[noreturn]] void differ(const Place& place, const std::string& field, std::size_t line,
                           const std::string& expected, const std::string& seen) const;

  Recording recording_;
  std::uint32_t index_ = 0;
  std::map<std::string, Deviation> deviations_;  // of "<node>.<port>[element]"
  std::uint64_t ticks_ = 0;
  std::uint64_t windows_ = 0;
  std::uint64_t received_ = 0;
  std::uint64_t sent_ = 0;
};

}  // namespace eagerx::conformance

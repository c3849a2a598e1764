// Progress of a training on the terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/curve.hpp"

namespace eagerx::train {

/// On a terminal, one line that is rewritten each second; elsewhere a new line every five seconds.
/// Goes to stderr.
class Progress {
 public:
  /// `name`: of one of several parallel trainings, whose lines begin with it and are not
  /// overwritten. Empty: a single training.
  Progress(std::uint64_t first_step, std::uint64_t last_step, bool has_success, bool is_quiet,
           std::string name = {});

  /// `point`: the last iteration; `stage`: its stage, in words; empty without stages.
  void show(const CurvePoint& point, const std::string& stage = {});
  /// Prints a separate line, and forgets the last return, because later episodes are from another
  /// stage.
  void begin_stage(const std::string& line);
  /// A line of its own.
  void say(const std::string& line);
  /// Removes the line of a terminal.
  void finish();
  /// Since the start.
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(const CurvePoint& point, const std::string& stage, double seconds) const;

  std::uint64_t first_step_, last_step_;
  bool has_success_, is_quiet_;
  std::string name_;
  bool is_terminal_;
  bool is_shown_ = false;
  double last_return_, last_evaluation_, last_success_;  // NaN: not yet
  Clock::time_point start_, shown_;
};

}  // namespace eagerx::train

// Progress of a long operation.
#pragma once

#include <chrono>
#include <string>

namespace eagerx::gen {

/// Lines on the standard error; on a terminal, each replaces the previous one. Operations shorter
/// than half a second print nothing.
class Progress {
 public:
  Progress(std::string what, bool quiet);
  /// May be called often. `done`: "3 of 40 files", or nothing.
  void at(const std::string& done);
  /// PortBindings the last line.
  void finish(bool good);

 private:
  void show(const std::string& text);
  [[nodiscard]] double seconds() const;

  std::string what_;
  bool quiet_, terminal_, shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double next_s_;
};

}  // namespace eagerx::gen

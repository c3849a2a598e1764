// Progress of a campaign on the terminal.
#pragma once

#include <chrono>
#include <cstdint>

namespace eagerx::campaign {

/// On a terminal, one line that is rewritten each second; elsewhere a new line every five seconds.
/// Goes to stderr.
class Progress {
 public:
  Progress(std::uint32_t runs, bool is_quiet);

  /// The number of runs done before.
  void begin(std::uint32_t done);
  void show(std::uint32_t done, std::uint32_t successes);
  /// Removes the line of a terminal.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::uint32_t runs_, before_ = 0;
  bool is_quiet_, is_terminal_, is_shown_ = false;
  Clock::time_point start_, shown_;
};

}  // namespace eagerx::campaign

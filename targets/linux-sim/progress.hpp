// A progress line on the terminal for long runs.
#pragma once

#include <cstdint>

namespace eagerx::linux_sim {

/// Draws on the standard error, only if that is a terminal, and only once a run has lasted a
/// second. Never allocates.
class Progress {
 public:
  Progress(std::uint64_t steps, bool wanted);

  void start(std::int64_t start_ns) { start_ns_ = last_ns_ = start_ns; }
  /// To be called after every step; reads the clock only now and then.
  void step(std::uint64_t done) {
    if (enabled_ && done >= next_) look(done);
  }
  /// Removes the line.
  void finish();

 private:
  void look(std::uint64_t done);
  void draw(std::uint64_t done, std::int64_t now) const;

  std::uint64_t steps_;
  std::uint64_t next_ = 1;
  std::uint64_t stride_ = 1;  // steps between two looks at the clock
  std::int64_t start_ns_ = 0;
  std::int64_t last_ns_ = 0;   // of the last look
  std::int64_t drawn_ns_ = 0;  // of the last drawing, 0 before the first
  bool enabled_;
};

}  // namespace eagerx::linux_sim

// A hub that waits for lost parts: `--reconnect`.
#pragma once

#include <cstdint>
#include <string>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/split.hpp>
#include <targets/linux-sim/summary.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Reconnects parts between two episodes. All parts then start a new session with their initial
/// state. The hub is safe while it waits. Allocates memory, and reports events.
class Reconnection {
 public:
  Reconnection(GraphProgram& program, const Options& options);

  /// Why `--reconnect` is not possible in this run, or nothing.
  std::string problem_of_options() const;
  /// Call it after the loss of a link and `steps` steps. True: all parts have started a new
  /// session. False: no `--reconnect`, the time has run out, or the run must end.
  bool link_again(std::uint64_t steps);
  bool has_lost() const { return losses_ > 0; }
  /// Adds counts to the summary. Sets `broken` to the reason for the end of the run if a part did
  /// not come back.
  void finish(Summary& summary, std::string& broken) const;

 private:
  struct Part {
    std::uint64_t losses = 0;
    bool is_away = false;   // its line is to be opened anew
    bool is_ready = false;  // in its new session
    std::string problem;    // of the last try
  };

  void note_losses(std::uint64_t steps);
  void note_loss(std::size_t part);
  bool wait_for_parts(std::uint64_t until_ns);
  bool try_part(std::size_t part, std::uint64_t until_ns);
  bool is_someone_else(std::size_t part) const;
  void give_up(std::size_t part);

  GraphProgram& program_;
  const Options& options_;
  PartLines where_;
  std::vector<Part> parts_;
  std::uint64_t losses_ = 0;
  std::string given_up_;
};

}  // namespace eagerx::linux_sim

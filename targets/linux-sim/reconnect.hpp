// A hub that waits for lost parts: `--reconnect`.
#pragma once

#include <cstdint>
#include <string>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/split.hpp>
#include <targets/linux-sim/summary.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Brings parts back between two episodes. All parts then are in a new session, so each is as new;
/// what they wait in is safe as long as it lasts. Allocates memory, and says what happens.
class Reconnection {
 public:
  Reconnection(GraphProgram& program, const Options& options);

  /// Why `--reconnect` is not possible in this run, or nothing.
  std::string problem_of_options() const;
  /// After a link is over; `steps` are done. True: all parts begin anew. False: there is no wait
  /// for parts, the time is over, or the run must end.
  bool link_again(std::uint64_t steps);
  bool has_lost() const { return losses_ > 0; }
  /// Counts for the summary; `broken` becomes why the run is over, if a part has not come back.
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

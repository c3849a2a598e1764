// The host's half of a split graph: its link to the board.
#pragma once

#include <cstdint>
#include <eagerx/link/host.hpp>
#include <string>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/summary.hpp>

namespace eagerx::linux_sim {

/// A link without the sizes of its frames, which are the graph's; split_app.hpp has it with them.
class SplitLink {
 public:
  virtual LinkPort& port() = 0;
  virtual link::Identity identity() const = 0;
  virtual void set_time_limit(std::uint64_t ns) = 0;
  virtual bool open(std::uint32_t session) = 0;
  virtual bool ok() const = 0;
  virtual link::Problem problem() const = 0;
  virtual const link::Greeting& board() const = 0;
  virtual const link::Statistics& statistics() const = 0;
  /// Nobody waits for the board any more.
  virtual void forget_silence() = 0;
  virtual bool finish(link::Report& report, CountListener& counts) = 0;

 protected:
  ~SplitLink() = default;
};

/// False if the board decides and does not know this agent.
bool board_knows(const GraphFacts& facts, target::Agent agent);

/// Why a link is over, for people.
std::string problem_of(SplitLink& link);

/// Connects with the board. Returns what went wrong; empty: nothing.
std::string connect(SplitLink& link, const Options& options);

/// The lines of a summary about the link.
void describe_link(Summary& summary, const char* board, const link::Statistics& statistics,
                   const link::Report& report);

}  // namespace eagerx::linux_sim

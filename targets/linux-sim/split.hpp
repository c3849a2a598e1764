// The hub of a graph that is split into parts: its links to them.
#pragma once

#include <cstdint>
#include <eagerx/link/star.hpp>
#include <string>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/link_port.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/summary.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// A link without the sizes of its frames, which are the graph's; split_app.hpp has it with them.
class SplitLink {
 public:
  virtual LinkPort& port() = 0;
  virtual const link::PartFacts& part() const = 0;
  virtual const link::PartProgress& progress() const = 0;
  virtual void set_time_limit(std::uint64_t ns) = 0;
  virtual bool open(std::uint32_t session) = 0;
  virtual bool ok() const = 0;
  virtual link::Problem problem() const = 0;
  virtual const link::Greeting& greeting() const = 0;
  virtual const link::Statistics& statistics() const = 0;
  /// Whether the hub may ask its parts, all of them, for messages before it needs these.
  virtual void set_pipelined(bool is_pipelined) = 0;
  /// The hub no longer waits for the board.
  virtual void forget_silence() = 0;
  virtual bool finish(link::Report& report, CountListener& counts) = 0;

 protected:
  ~SplitLink() = default;
};

/// False if a part decides and does not know this agent.
bool part_knows(const GraphFacts& facts, target::Agent agent);

/// "a part of this graph runs on mps2-an386", "part `vision` of this graph is a program of its
/// own": for options that work without parts only.
std::string parts_elsewhere(const GraphFacts& facts);
/// "the board", "part `vision`"
std::string name_of_part(const link::PartFacts& part);

/// Where each part is, and the file of the key of its line, which may be empty.
struct PartLines {
  std::vector<std::string> lines, keys;  // [parts]
};
/// The problem of the lines in the options; empty: each part has one.
std::string find_parts(const GraphFacts& facts, const Options& options, PartLines& found);
/// Opens the line to a part, which may already be open, and begins a session. Returns the problem.
std::string connect_part(SplitLink& link, const std::string& line, const std::string& key_file,
                         const GraphFacts& facts, const Options& options, double most_s);
/// Begins a session on an open line. Returns the problem.
std::string greet_part(SplitLink& link, const GraphFacts& facts, double most_s);
/// The reason why a link has ended, for messages; empty if it works.
std::string why_over(SplitLink& link, const GraphFacts& facts);
/// Connects to all parts. Returns the problem; empty: none.
std::string connect_parts(GraphProgram& program, const Options& options);
/// Whether all links work.
bool links_are_whole(GraphProgram& program);
/// Ends the session of each part, and adds lines and counts of each to the summary.
/// Returns why the run was over before its time, with the part's name; empty: it was not.
std::string end_links(GraphProgram& program, Summary& summary);

}  // namespace eagerx::linux_sim

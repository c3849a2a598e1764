// Options that several commands of eagerx-gen share. A command's own options are a struct in its
// own file, derived from the struct here that it needs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/read/rational.hpp"

namespace eagerx::gen {

/// How problems are printed.
struct MessageOptions {
  bool json = false;  // --diagnostics=json
  bool quiet = false;
};

/// Of commands that look things up in the library.
struct LibraryOptions : MessageOptions {
  std::vector<std::string> paths;  // folders of the user's own entities and targets
};

/// The purpose of the output.
enum class Purpose : std::uint8_t {
  program,
  training,    // the whole graph, whatever its agent is
  campaign,    // the whole graph, with its agent
  simulation,  // the whole graph, with whatever agent
  recording,   // the whole graph, with its agent, for a library that is cut out of it
};

/// A graph, and options that override parts of its file.
struct GraphOptions : LibraryOptions {
  std::string graph;
  std::string variant;                              // empty: the graph as it is written
  std::string engine, real;                         // empty: the graph's
  std::optional<Rational> engine_rate_hz, rate_hz;  // without: the graph's
  std::vector<std::string> targets;                 // empty: linux-sim
  std::vector<std::string> split;                   // NAMES=BOARD; empty: the graph's placement
  std::vector<std::string> of;                      // nodes that are cut out; empty: all
  std::string agent_policy;                         // a weight file; empty: the graph's agent
  Purpose purpose = Purpose::program;
  bool warnings_as_errors = false;
  bool keep_processes = false;  // of a file that EAGERx saved: nodes with NEW_PROCESS become parts
};

/// A graph and its output.
struct GenerateOptions : GraphOptions {
  std::string output;  // a folder; empty: generated/<name of the graph>
  std::string depfile;
  std::string part;  // of a placed graph: only this one, in the language that `packages` names
  std::vector<std::string> packages;  // kinds of packages that the output is to be as well
  bool library = false;               // headers for your own main loop, no program
  bool standalone = false;            // the output has all headers it needs
  bool sanitize = false;              // programs are built with sanitizers, and check indexes
  bool for_this_machine = false;      // vectorized for its processor alone

  /// A part cut out of a graph is always a library.
  [[nodiscard]] bool makes_library() const { return library || !of.empty(); }
};

}  // namespace eagerx::gen

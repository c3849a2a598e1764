// The page of a graph while its program runs: a server of this machine that shows it, and tells it
// by Foxglove's protocol what a source tells.
#pragma once

#include <string>

#include "generator/tools/monitor/monitor.hpp"

namespace eagerx::gen {

struct LiveOptions {
  std::string source;  // of open_source()
  std::string layout;  // the text of a board's telemetry.json; empty: not known
  std::string page;    // HTML
};

/// Prints the address of the page, whose key is another one each time, and serves it until it is
/// interrupted. Returns the exit code; problems are printed.
int serve_live(LiveOptions options, const WatchedGraph& graph);

}  // namespace eagerx::gen

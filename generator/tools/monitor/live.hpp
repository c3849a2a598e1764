// The live page of a running program: a local server serves the page, and sends it the events of a
// source in Foxglove's protocol.
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

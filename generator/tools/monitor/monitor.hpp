// Watches a source: on a screen, or in lines for scripts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

struct MonitorOptions {
  std::string source;
  std::string layout;                // the text of a board's telemetry.json; empty: not known
  std::string record;                // a file that gets the messages; empty: none
  std::vector<std::string> forward;  // where else they go
  bool once = false;                 // one table of lines, then the end
  bool lines = false;                // tables of lines instead of a screen
  double every_s = 1.0;              // between tables; of `once` from the first message on
  double timeout_s = 10.0;           // for the first message; of lines also between messages
};

/// Whether `record` may have this name, and `forward` this destination.
bool is_recording(const std::string& path);
bool is_destination(const std::string& text);

/// The graph of the program that is watched.
struct WatchedGraph {
  const Plan* plan = nullptr;
  std::string file;        // as the user wrote it
  std::uint64_t hash = 0;  // of its program
};

/// `graph`: null: none was named. Returns the exit code; problems are printed.
int watch(const MonitorOptions& options, const WatchedGraph* graph);

}  // namespace eagerx::gen

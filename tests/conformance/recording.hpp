// A recorded run: what every callback was given and what it sent, tick by tick. The format is
// described in README.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eagerx::conformance {

/// The messages of an input at a tick, oldest first. `values` has the elements of all of them.
struct RecordedWindow {
  std::size_t line = 0;  // in the file
  std::vector<std::uint64_t> seq;
  std::vector<double> sent_s;
  std::vector<double> values;
};

/// Message values: of an output, or of an observation as the agent sees it (padded).
struct RecordedMessage {
  std::size_t line = 0;
  std::vector<double> values;
};

struct RecordedTick {
  std::size_t line = 0;
  double time_s = 0.0;
  std::map<std::string, RecordedWindow> inputs;
  std::map<std::string, RecordedMessage> outputs;
  std::map<std::string, RecordedMessage> observations;  // of the environment only
  bool seen = false;                                    // by the comparison, its inputs
  std::size_t seen_outputs = 0;
};

struct RecordedEpisode {
  std::map<std::string, RecordedMessage> states;
  std::map<std::pair<std::string, std::uint64_t>, RecordedTick> ticks;  // node, tick

  /// The action of a step; nothing when the episode is over.
  const RecordedTick* action(std::uint64_t step) const;
};

struct Recording {
  std::string path;
  std::vector<RecordedEpisode> episodes;
  // Of "<node>.<port>", one for each element; ports without one must be equal.
  std::map<std::string, std::vector<double>> tolerances;

  /// Of element `i` of all the messages of a port.
  double tolerance(const std::string& port, std::size_t i) const;
};

/// Reads `path`. Says what is wrong with it on the standard error; nullopt then.
std::optional<Recording> read_recording(const std::string& path);

}  // namespace eagerx::conformance

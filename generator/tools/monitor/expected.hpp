// Properties of watched messages in a graph.
#pragma once

#include <cstdint>
#include <map>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <vector>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

struct ExpectedChannel {
  trace_log::RecordedChannel channel;
  std::vector<double> low, high;     // what a message may hold, of each element; empty: no bounds
  std::string port;                  // as the graph calls it
  std::vector<std::uint32_t> shape;  // none: one number
  bool is_sensor = false;
  std::vector<double> safe;  // of an action where the graph has `safety:`, of each element
};

struct Expected {
  std::string file;                                        // of the graph, as the user wrote it
  std::string graph;                                       // its name
  std::string engine;                                      // its id
  std::uint64_t hash = 0;                                  // of its program
  double step_hz = 0.0;                                    // the environment's rate
  bool has_scenes = false;                                 // `render:` shows a drawing
  std::vector<ExpectedChannel> channels;                   // as in the trace
  std::map<std::string, std::size_t, std::less<>> places;  // by name

  [[nodiscard]] const ExpectedChannel* find(std::string_view name) const {
    const auto found = places.find(name);
    return found == places.end() ? nullptr : &channels[found->second];
  }
};

Expected expected_of(const Plan& plan, std::string file, std::uint64_t hash);

/// Why a stream with these channels is none of the graph; empty: it may be.
std::string problem_with_channels(const Expected& expected,
                                  const std::vector<trace_log::RecordedChannel>& channels);

}  // namespace eagerx::gen

// Layout of a board's telemetry: `telemetry.json`, a file next to the program, as a struct.
// targets/README.md has the format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <vector>

namespace eagerx::telemetry {

struct Channel {
  std::string name;  // in traces: "node/output"
  std::string port;  // in graphs: "smooth.filtered"
  trace_log::Dtype dtype = trace_log::Dtype::float32;
  std::vector<std::uint64_t> shape;
  std::uint64_t size = 0;  // elements
  std::size_t offset = 0;  // in the record
};

/// The channels that come in one record.
struct Group {
  std::uint64_t rate_num = 1, rate_den = 1;  // of the messages [Hz]
  std::uint64_t every = 1;                   // one of this many is sent
  std::size_t bytes = 0;                     // of a record
  std::vector<Channel> channels;
};

struct Layout {
  std::string graph;
  std::uint64_t hash = 0;  // Graph::kGraphHash of the program
  std::uint16_t runtime = 0;
  std::uint32_t baud = 0;
  std::vector<Group> groups;
};

std::size_t bytes_of(trace_log::Dtype dtype);
/// Why nothing can be decoded with this layout; empty if there is no reason.
std::string problem_with(const Layout& layout);

}  // namespace eagerx::telemetry

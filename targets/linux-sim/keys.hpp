// The keys of a graph's TCP lines, as command lines name them.
#pragma once

#include <string>
#include <targets/linux-sim/link_port.hpp>
#include <vector>

namespace eagerx::linux_sim {

struct GraphFacts;

/// The key file for the line to each part; empty if there is none. `given`: `PART=FILE` for one
/// part, FILE for all others with a TCP line. Returns the problem.
std::string find_keys(const std::vector<std::string>& given, const GraphFacts& facts,
                      const std::vector<std::string>& lines, std::vector<std::string>& files);

/// Reads the key with which `line` is then opened. Returns the problem.
std::string use_key_of(const std::string& file, const std::string& line, LinkPort& port);

}  // namespace eagerx::linux_sim

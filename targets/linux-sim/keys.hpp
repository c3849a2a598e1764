// The keys of a graph's TCP lines, as command lines name them.
#pragma once

#include <string>
#include <targets/linux-sim/link_port.hpp>
#include <vector>

namespace eagerx::linux_sim {

struct GraphFacts;

/// The file of a key for the line to each part; empty where there is none. `given`: `PART=FILE` of
/// one part, FILE of all others that have a TCP line. Returns what is wrong with that.
std::string find_keys(const std::vector<std::string>& given, const GraphFacts& facts,
                      const std::vector<std::string>& lines, std::vector<std::string>& files);

/// Reads the key for `line`, which is then opened with it. Returns what is wrong.
std::string use_key_of(const std::string& file, const std::string& line, LinkPort& port);

}  // namespace eagerx::linux_sim

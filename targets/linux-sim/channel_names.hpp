// Names of channels on the command line.
#pragma once

#include <runtime/host/base/nearest.hpp>
#include <string>
#include <string_view>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/options.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// How the graph calls the messages of a channel: "arm.x, arm.same" is two names.
std::vector<std::string> ports_of(const Channel& channel);
/// The ports of composites that it is, too.
std::vector<std::string> aliases_of(const GraphFacts& facts, std::size_t channel);

/// Writes the names in `--replay-given`, `--identify-sensors` and `--publish-only` as traces spell
/// them: `robot.gyro` is `robot/gyro/y`. Prints a note for each. Returns the problem of an unknown
/// or ambiguous name; empty: none.
std::string name_channels(Options& options, const GraphFacts& facts);

}  // namespace eagerx::linux_sim

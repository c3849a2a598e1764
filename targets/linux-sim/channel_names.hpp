// Names of channels on the command line, as traces spell them.
#pragma once

#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

/// The options with the names of channels in `--replay-given`, `--identify-sensors` and
/// `--publish-only` as the program spells them: `robot.gyro` is `robot/gyro/y`. A note tells of
/// each. A name that no channel has, or several, stays: each option refuses it in its own words.
Options with_channels_named(Options options, const GraphFacts& facts);

}  // namespace eagerx::linux_sim

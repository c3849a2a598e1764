// The parts of a placed graph that run on this machine, together with its hub.
#pragma once

#include <string>
#include <vector>

#include "generator/driver/build/built.hpp"

namespace eagerx::gen {

/// Whether each part can be started here or has a `--link` in `words`, the options of the hub's
/// program, and whether keys of lines exist. Otherwise reports E0518 with the command to type, here
/// or on the other machine.
bool check_parts(Run& run, const std::vector<BuiltProgram>& programs,
                 const std::vector<std::string>& words);

/// Starts those that `words` has no `--link` to, and adds theirs. They end when this process does,
/// also if it has become the hub. False: E0518 a part that does not start.
bool start_parts(Run& run, const std::vector<BuiltProgram>& programs,
                 std::vector<std::string>& words);

}  // namespace eagerx::gen

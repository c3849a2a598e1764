// Shared by tests of SAC.
#pragma once

#include <string>

#include "tests/unit/train/common.hpp"

namespace eagerx::train {

/// A table of a run.
inline const std::string kHeader =
    "episode,step,time_s,angle[0],angle[1],speed,voltage,task.reward,task.terminated,"
    "task.truncated,task.success,task.angle\n";
/// Two episodes, of which the first ran out of time and the second fell.
inline const std::string kRows =
    "0,0,0,1,0,0.5,,,,,,\n"
    "0,1,0.1,0.9,0.1,0.25,-1,-2,0,0,0,-2\n"
    "0,2,0.2,0.8,0.2,0.125,4,-3,0,1,0,-3\n"
    "1,0,0,0,1,7,,,,,,\n"
    "1,1,0.1,0.5,0.5,8,0.5,-10,1,0,0,-10\n";

}  // namespace eagerx::train

// Actions and observations of a graph in words, for --help.
#pragma once

#include <cstdint>
#include <string>
#include <targets/linux-sim/fields.hpp>

namespace eagerx::linux_sim {

/// As graphs and numpy write it: "float32".
const char* dtype_name(Scalar scalar);

/// A line for each action and observation, such as "  name  float32, shape [1], from -2 to 2".
std::string describe(const Fields& fields);

}  // namespace eagerx::linux_sim

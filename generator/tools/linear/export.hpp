// A sampled system for other tools: the arrays of a file for NumPy, and a StateSpace for a graph.
#pragma once

#include <string>

#include "generator/tools/linear/write.hpp"

namespace eagerx::gen {

/// A, B, C, D, dt, names and units of states, inputs and outputs, the operating point, poles; of an
/// opened loop also its response. Without the opened port's own inputs and outputs.
std::string linear_npz(const LinearReport& report);

/// The node StateSpace that does what the system does near the operating point. `problem`: why
/// there is none.
std::string state_space_yaml(const LinearReport& report, std::string& problem);

}  // namespace eagerx::gen

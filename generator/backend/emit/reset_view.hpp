// The part of program.hpp that runs at a reset.
#pragma once

#include <string>
#include <vector>

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// The engine, then everything in the order in which it runs; the environment left out.
std::vector<std::size_t> nodes_in_order(const Plan& plan);

/// ", simulator" of an engine node, else nothing.
std::string simulator_argument(const Plan& plan, const ProgramNames& names, std::size_t node);

/// States, delays, cursors and reset nodes.
View reset_view(const Plan& plan, const ProgramNames& names);

}  // namespace eagerx::gen

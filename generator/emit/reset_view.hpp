// The part of program.hpp that runs at a reset.
#pragma once

#include <string>
#include <vector>

#include "generator/emit/names.hpp"

namespace eagerx::gen {

/// "a, b, c"
std::string joined(const std::vector<std::string>& items);
/// The same in braces: on one line if that ends within 100 columns, else one item a line. `before`
/// is how many columns the line has before the braces; it begins `indent` columns from the left.
std::string braced(const std::vector<std::string>& items, std::size_t indent, std::size_t before);

/// The engine, then everything in the order in which it runs; the environment left out.
std::vector<std::size_t> nodes_in_order(const Plan& plan);

/// ", simulator" of an engine node, else nothing.
std::string simulator_argument(const Plan& plan, const ProgramNames& names, std::size_t node);

/// Adds states, delays, cursors and reset nodes to the view of program.hpp.
void add_reset(const Plan& plan, const ProgramNames& names, View& view);

}  // namespace eagerx::gen

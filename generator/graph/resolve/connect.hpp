// Connections between ports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void connect(UnresolvedGraph& draft);  // the user's connections; unconnected ports
/// The space that an input is declared with, by the name that connections call it; nullopt if there
/// is none.
std::optional<PartialSpace> declared_space(const UnresolvedGraph& draft, const std::string& port);
/// All names that `to:` may say.
std::vector<std::string> input_names(const UnresolvedGraph& draft);

}  // namespace eagerx::gen

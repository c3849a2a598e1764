// Rebases file names of a composite or an extended graph, which are relative to its own folder,
// onto the folder of the graph that uses it.
#pragma once

#include <filesystem>
#include <string>

#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {

/// Policies, tables and the like of an entity inside, as the graph at `graph_path` would name them.
void name_files_from(const Entity& composite, const std::string& graph_path, YamlValue& settings);

/// The same for all that a graph in the folder `from` names, as one in `to` would name it.
void name_files_of_graph(YamlValue& graph, const std::filesystem::path& from,
                         const std::filesystem::path& to);

}  // namespace eagerx::gen

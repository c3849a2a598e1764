// `eagerx-gen new example NAME`: copies an example into a folder of your own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Names of the examples that are installed, sorted.
std::vector<std::string> example_names();

/// Copies the example into `parent`, and next to it the other examples that its files name and that
/// are not there yet. The folders that were made, the example first; empty if there is a problem:
/// E0301 there is no such example, E0902 there is something at its place.
std::vector<std::filesystem::path> copy_example(const std::string& name,
                                                const std::filesystem::path& parent,
                                                Diagnostics& diagnostics);

}  // namespace eagerx::gen

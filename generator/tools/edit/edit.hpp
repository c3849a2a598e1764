// Changes of a graph's text: splices with a reason. The rest stays as it was written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/outline/splice.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Every place that names an object or a node: its key, its ports in connections, and its uses in
/// settings, limits, placement, measures and pictures, also in variants. Empty if the name is
/// unknown.
std::vector<Bytes> uses_of(std::string_view text, const std::string& name);

/// The objects and nodes of a graph file.
std::vector<std::string> owners_of(std::string_view text);

/// Whether it can be the name of an object or a node, and none has it.
bool is_free_name(std::string_view text, const std::string& name);

/// The object or node that the word at byte `at` names; empty: none.
std::string name_at(std::string_view text, std::size_t at);

/// Renames an object or a node. nullopt if the first name is unknown, or the second one is not
/// valid.
std::optional<Edit> rename(std::string_view text, const std::string& from, const std::string& to);

}  // namespace eagerx::gen

// Parts of the answer to `./state`.
#pragma once

#include <string>
#include <string_view>

#include "generator/frontend/outline/outline.hpp"
#include "generator/support/json/json.hpp"
#include "generator/tools/serve/workshop.hpp"

namespace eagerx::gen::serve {

/// The state of a graph, which may be incomplete.
Json outline_json(std::string_view text);

/// All of it as it is nested: texts, lists and mappings, null where nothing is written.
Json tree_json(std::string_view text);

/// The problems of a graph's text, each with the path of what is there.
Json problems_json(const Workshop::Checked& checked, const std::string& path,
                   std::string_view text);

Json path_json(const OutlinePath& path);
/// Nothing: it is no path.
std::optional<OutlinePath> path_of(const Json* json);

}  // namespace eagerx::gen::serve

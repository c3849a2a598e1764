// The view for templates of other languages.
#pragma once

#include <cstdint>
#include <string>

#include "generator/backend/emit/render.hpp"
#include "generator/backend/languages/layout.hpp"

namespace eagerx::gen {

/// Whether a part of this target takes the node as its entity has it, and leaves no blank for it.
bool is_imported(const Target& target, const GraphNode& node);
/// Whether Python can import a file of this name.
bool is_module(const std::string& file);

/// `hash`: of the part.
View language_view(const Plan& plan, const PartLayout& layout, std::uint64_t hash,
                   const std::string& version);

}  // namespace eagerx::gen

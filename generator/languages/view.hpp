// What the templates of other languages are rendered with.
#pragma once

#include <cstdint>
#include <string>

#include "generator/emit/render.hpp"
#include "generator/languages/layout.hpp"

namespace eagerx::gen {

/// `hash`: of the part.
View language_view(const Plan& plan, const PartLayout& layout, std::uint64_t hash,
                   const std::string& version);

}  // namespace eagerx::gen

// Rewords yaml-cpp's messages for users who write graphs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "generator/frontend/read/locator.hpp"
#include "generator/frontend/read/tree_builder.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Adds the error for a YAML::ParserException with this message at this offset (npos: none).
/// `builder` knows the collections that were open at that moment.
void report_yaml_error(std::string_view message, std::size_t offset, const Locator& locator,
                       const TreeBuilder& builder, Diagnostics& diagnostics);

}  // namespace eagerx::gen

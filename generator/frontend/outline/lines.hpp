// Lines and columns of a text as bytes.
#pragma once

#include <cstdint>
#include <string_view>

#include "generator/frontend/outline/outline.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Line `line` (from 0) without its newline; after the last one, the end of the text.
Bytes line_of(std::string_view text, std::uint32_t line);

/// The lines of a diagnostic's span; of one without a line, the first line.
Bytes bytes_of(std::string_view text, const Span& span);

}  // namespace eagerx::gen

// Breaks long expressions of generated C++ after their operators.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// `a = b + c;` over several lines: operands aligned after the `=` or, if that is too narrow, on
/// the next line; arguments after their bracket or on the next line. `line` begins with `indent`
/// blanks. Empty for other statements.
std::string wrapped_assignment(std::string_view line, std::size_t indent);

}  // namespace eagerx::gen

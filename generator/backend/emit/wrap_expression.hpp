// Long expressions of generated C++, broken behind their operators.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// `a = b + c;` over several lines: operands below each other behind the `=`, or, where that is too
/// narrow, below; arguments behind their bracket or below. `line` begins with `indent` blanks.
/// Empty for what is no such statement.
std::string wrapped_assignment(std::string_view line, std::size_t indent);

}  // namespace eagerx::gen

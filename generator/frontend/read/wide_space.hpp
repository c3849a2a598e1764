// Unicode spaces where YAML needs a plain one: editors and web pages insert them invisibly.
#pragma once

#include "generator/frontend/read/locator.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Reports the first no-break or other wide space that indents a line, or follows the colon of a
/// key or a bracket or comma of a flow collection (E0105). In texts and comments it is a character
/// like others. False: there is one.
bool check_wide_spaces(const Locator& locator, Diagnostics& diagnostics);

}  // namespace eagerx::gen

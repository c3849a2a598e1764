#pragma once

#include <string>

namespace eagerx::gen {

/// The readable name of a function from its mangled one: "Program::before" for
/// `_ZN6graphs1g7ProgramI…E6beforeI…E`, without namespaces, arguments and what is behind a dot.
/// Other names stay as they are.
std::string function_name(const std::string& mangled);

}  // namespace eagerx::gen

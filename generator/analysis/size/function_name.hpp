#pragma once

#include <string>

namespace eagerx::gen {

/// What a person calls a function whose name the compiler has mangled: "Program::before" for
/// `_ZN6graphs1g7ProgramI…E6beforeI…E`, without namespaces, arguments and what is behind a dot.
/// Other names stay as they are.
std::string function_name(const std::string& mangled);

}  // namespace eagerx::gen

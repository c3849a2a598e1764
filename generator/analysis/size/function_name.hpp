#pragma once

#include <string>

namespace eagerx::gen {

/// The readable name of a function from its mangled one: "Program::run_slot" for
/// `_ZN6graphs1g7ProgramI…E8run_slotI…E`, without namespaces, arguments and the part after a dot.
/// Other names are unchanged.
std::string function_name(const std::string& mangled);

}  // namespace eagerx::gen

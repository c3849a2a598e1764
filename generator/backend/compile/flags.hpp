// The flags of everything that includes the runtime, as CMake gives them (runtime/flags.cmake).
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// CMake's name of the compiler that printed `version` when asked with --version: "GNU", "Clang";
/// empty: another one.
std::string compiler_id(std::string_view version);

/// The flags of runtime/flags.txt for that compiler, in their order.
std::vector<std::string> runtime_flags(std::istream& list, std::string_view compiler_id);

}  // namespace eagerx::gen

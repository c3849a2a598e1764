// Other programs: the compiler and those that read what it makes. Inside compile/ only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

struct ToolResult {
  int exit_code = 0;
  std::string output;  // standard output and error, as they came
};

/// Runs a program in the C locale; nothing if it could not be started.
std::optional<ToolResult> run_tool(const std::vector<std::string>& command);

/// A line that compilers write: "gain.hpp:12:5: error: text [-Wname]".
struct CompilerMessage {
  std::string file;
  std::uint32_t line = 0, column = 0;
  bool error = false;
  std::string text;
};
std::vector<CompilerMessage> messages_in(std::string_view output);

}  // namespace eagerx::gen

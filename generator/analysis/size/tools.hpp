// The programs of the compiler's package that read an image (nm, addr2line, objdump, readelf).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// Longer lines are not looked at: no compiler writes such.
constexpr std::size_t kMaxLine = 16'000;

/// Runs a program, gives every line of its standard output to `line`, and returns its exit code;
/// -1 if it could not be started, or a signal ended it. Its standard error is thrown away. `input`:
/// the descriptor that it reads from; -1: none.
int for_each_line(const std::vector<std::string>& command,
                  const std::function<void(std::string_view)>& line, int input = -1);

/// The prefix of these programs' names for an image, by the machine in its ELF header:
/// `arm-none-eabi-`, `riscv64-unknown-elf-`, or nothing for the machine that this runs on. nullopt:
/// no ELF file, or one that cannot be read.
std::optional<std::string> tool_prefix(const std::string& image);

}  // namespace eagerx::gen

// Semihosting: services of the debugger or emulator that runs the program. Source: Arm,
// "Semihosting for AArch32 and AArch64", 2023Q3; "RISC-V Semihosting", 0.4.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::board {

/// Writes a text that ends with 0 (SYS_WRITE0).
void semihosting_write(const char* text);

/// Copies the command line, its words separated by spaces, into `buffer`, ends it with 0 and
/// returns its length; -1 if there is none or it is too long (SYS_GET_CMDLINE).
int semihosting_command_line(char* buffer, std::size_t size);

/// Ends the program; the emulator's exit code is `code` (SYS_EXIT_EXTENDED).
[[noreturn]] void semihosting_exit(int code);

}  // namespace eagerx::board

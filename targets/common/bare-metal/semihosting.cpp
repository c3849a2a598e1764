#include <targets/common/bare-metal/semihosting.hpp>

#ifdef EAGERX_ARGUMENTS  // CMake's: no host answers, and a call would be a fault
#include <cstring>
#include <targets/common/bare-metal/console.hpp>

namespace eagerx::board {

void semihosting_write(const char* text) {
  for (; *text != '\0'; ++text) uart_write(*text);
}

int semihosting_command_line(char* buffer, std::size_t size) {
  constexpr char kLine[] = "program " EAGERX_ARGUMENTS;
  if (sizeof kLine > size) return -1;
  std::memcpy(buffer, kLine, sizeof kLine);
  return static_cast<int>(sizeof kLine - 1);
}

void semihosting_exit(int /*code*/) {
  while (true) {
  }
}

}  // namespace eagerx::board

#else

namespace eagerx::board {
namespace {

enum class Operation : std::uint32_t {
  write0 = 0x04,
  get_command_line = 0x15,
  exit_extended = 0x20
};

/// The number of the operation in the first register of an argument, its block in the second, the
/// result in the first.
std::int32_t call(Operation operation, const void* argument) {
#if defined(__riscv)
  register auto a0 asm("a0") = static_cast<std::uint32_t>(operation);
  register const void* a1 asm("a1") = argument;
  // The three instructions must be 32 bits wide, and lie in one page.
  asm volatile(
      ".balign 16\n"
      ".option push\n"
      ".option norvc\n"
      "slli zero, zero, 0x1f\n"
      "ebreak\n"
      "srai zero, zero, 7\n"
      ".option pop\n"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return static_cast<std::int32_t>(a0);
#else
  register auto r0 asm("r0") = static_cast<std::uint32_t>(operation);
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return static_cast<std::int32_t>(r0);
#endif
}

}  // namespace

void semihosting_write(const char* text) {
  call(Operation::write0, text);
}

int semihosting_command_line(char* buffer, std::size_t size) {
  struct {
    char* text;
    std::size_t size;
  } block{buffer, size};
  return call(Operation::get_command_line, &block) == 0 ? static_cast<int>(block.size) : -1;
}

void semihosting_exit(int code) {
  constexpr std::uint32_t kApplicationExit = 0x20026;
  const std::uint32_t block[2] = {kApplicationExit, static_cast<std::uint32_t>(code)};
  call(Operation::exit_extended, block);
  while (true) {
  }
}

}  // namespace eagerx::board

#endif

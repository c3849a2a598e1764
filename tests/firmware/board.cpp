// Does what the last word of its command line says: faults, text, exit codes.
#include <cstdint>
#include <string_view>
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/bare-metal/semihosting.hpp>
#include <targets/common/bare-metal/stack.hpp>

namespace {

using eagerx::board::console;

#ifdef __arm__
// Addresses without memory; code has an odd one.
constexpr std::uintptr_t kNoMemory = 0x60000000;
constexpr std::uintptr_t kNoCode = 0x70000001;
void undefined_instruction() {
  asm volatile("udf #0");
}
void system_call() {
  asm volatile("svc 0");
}
#else
constexpr std::uintptr_t kNoMemory = 0x08000000;
constexpr std::uintptr_t kNoCode = 0x08000000;
void undefined_instruction() {
  asm volatile("unimp");
}
void system_call() {
  asm volatile("ecall");
}
#endif

volatile int zero = 0;
float initialised = 0.1F;  // .data

volatile std::uint32_t& memory(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

[[gnu::noinline]] int recurse(int depth) {
  volatile int frame[64];
  frame[0] = depth;
  return recurse(depth + 1) + frame[0];
}

/// Uses at least `words` words of stack.
[[gnu::noinline]] void use_stack() {
  volatile std::uint32_t words[500];
  for (volatile std::uint32_t& word : words) word = 1;
}

int print() {
  console.text("float ");
  console.number(initialised * 3.0F);
  console.text("\ndouble ");
  console.number(static_cast<double>(initialised) + 1e-3);
  console.text("\ninteger ");
  console.number(-42);
  console.text("\nhex ");
  console.hex(std::uint32_t{0xbeef});
  console.text("\n");
  return 0;
}

/// Sends every character that comes in back with the next one's code, up to the end of a line.
int echo() {
  eagerx::board::uart_write('>');
  char character = 0;
  while (character != '\n') {
    if (!eagerx::board::uart_read(character)) continue;
    eagerx::board::uart_write(character == '\n' ? character : static_cast<char>(character + 1));
  }
  return 0;
}

int run(std::string_view what) {
  if (what == "print") return print();
  if (what == "uart") return console.send_to(eagerx::board::Output::uart), print();
  if (what == "echo") return echo();
  if (what == "exit") return 7;
  if (what == "undefined") undefined_instruction();
  if (what == "divide") return 5 / zero;
  if (what == "write") return memory(kNoMemory) = 1, 0;
  if (what == "jump") return reinterpret_cast<void (*)()>(kNoCode)(), 0;
  if (what == "overflow") return recurse(0);
  if (what == "svc") system_call();
  if (what == "stack") {
    use_stack();
    console.number(eagerx::board::stack_used_bytes());
    console.text("\n");
    return 0;
  }
  return 1;
}

}  // namespace

int main() {
  char line[512];
  const int length = eagerx::board::semihosting_command_line(line, sizeof line);
  std::string_view word(line, length < 0 ? 0 : static_cast<std::size_t>(length));
  word.remove_prefix(word.rfind(' ') + 1);
  const int code = run(word);
  console.flush();
  return code;
}

// Traps switch outputs off, report their cause and end the program. Source: "The RISC-V Instruction
// Set Manual, Volume II: Privileged Architecture", 20211203, 3.1.15 (mcause).
#include <cstdint>
#include <eagerx/memory_fault.hpp>
#include <iterator>
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/bare-metal/semihosting.hpp>
#include <targets/common/bare-metal/stack.hpp>
#include <targets/common/bare-metal/start.hpp>

extern "C" {
void Trap_Handler();
[[noreturn, gnu::used]] void eagerx_report_trap(std::uint32_t cause, std::uint32_t address,
                                                std::uint32_t value);
}

namespace {

using eagerx::board::console;

constexpr std::uint32_t kInterrupt = 1U << 31U;

const char* cause_of(std::uint32_t cause) {
  constexpr const char* kCauses[] = {
      "jump to an address that is not aligned",
      "instruction fetched from where there is no memory",
      "undefined instruction",
      "breakpoint",
      "unaligned read",
      "read from where there is no memory",
      "unaligned write",
      "write to where there is no memory",
      "unexpected system call",
      "unexpected system call",
      "unexpected system call",
      "unexpected system call",
  };
  return cause < std::size(kCauses) ? kCauses[cause] : "unexpected trap";
}

/// Whether `address` is in what guard_stack() forbids.
bool below_stack(std::uint32_t address) {
  constexpr std::uint32_t kGuardBytes = 32768;
  const auto bottom = reinterpret_cast<std::uintptr_t>(eagerx_stack_bottom);
  return address < bottom && address >= bottom - kGuardBytes;
}

}  // namespace

void eagerx_report_trap(std::uint32_t cause, std::uint32_t address, std::uint32_t value) {
  if (eagerx_outputs_off != nullptr) eagerx_outputs_off();
  console.text((cause & kInterrupt) != 0 ? "error: unexpected interrupt (" : "error: trap (");
  console.number(cause & ~kInterrupt);
  console.text("): ");
  if ((cause & kInterrupt) == 0) {
    console.text(below_stack(value) ? "stack overflow" : cause_of(cause));
  }
  console.text(", value 0x");
  console.hex(value);
  console.text(", at address 0x");
  console.hex(address);
  console.text("\n");
  console.flush();
  eagerx::board::semihosting_exit(eagerx::board::kFault);
}

// Corrupted memory ends the program like every other fault.
void eagerx_memory_fault() {
  __builtin_trap();
}

// The stack may be what is broken: report on a fresh one, the handler never returns.
[[gnu::naked, gnu::aligned(4)]] void Trap_Handler() {
  asm volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      "csrr a0, mcause\n"
      "csrr a1, mepc\n"
      "csrr a2, mtval\n"
      "la sp, eagerx_stack_top\n"
      "j eagerx_report_trap\n"
      ".option pop\n");
}

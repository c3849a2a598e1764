// From reset to main on a RISC-V core in machine mode. Source: "The RISC-V Instruction Set Manual,
// Volume II: Privileged Architecture", 20211203, 3.1.6 (mstatus), 3.7 (physical memory protection).
#include <cstddef>
#include <cstdint>
#include <targets/common/bare-metal/semihosting.hpp>
#include <targets/common/bare-metal/start.hpp>

int main();

extern "C" {
void Reset_Handler();
[[noreturn, gnu::used]] void eagerx_start();
}

namespace {

/// Forbids the 32 kB below the stack, which is the lowest thing in RAM: running over its end is a
/// fault and not a mystery. The region is locked, so that it binds machine mode too.
void guard_stack() {
  constexpr std::uintptr_t kGuardBytes = 32768;
  constexpr std::uint32_t kLockedPowerOfTwoNoAccess = 0x98;
  const auto base = reinterpret_cast<std::uintptr_t>(eagerx_stack_bottom) - kGuardBytes;
  if (base % kGuardBytes != 0) return;
  const std::uintptr_t region = (base >> 2U) | (kGuardBytes / 8 - 1);
  asm volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      "csrw pmpaddr0, %0\n"
      "csrw pmpcfg0, %1\n"
      ".option pop\n" ::"r"(region),
      "r"(kLockedPowerOfTwoNoAccess)
      : "memory");
}

}  // namespace

void eagerx_start() {
  using namespace eagerx::board;
  paint_stack();
  initialise_memory();
  guard_stack();
  run_constructors();
  semihosting_exit(main());
}

// Naked: there is no stack yet, and the floating-point unit is off.
[[gnu::naked, gnu::section(".vectors")]] void Reset_Handler() {
  asm volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      ".option norelax\n"
      "la gp, __global_pointer$\n"
      ".option pop\n"
      ".option push\n"
      ".option arch, +zicsr\n"
      "la sp, eagerx_stack_top\n"
      "la t0, Trap_Handler\n"
      "csrw mtvec, t0\n"
#ifdef __riscv_flen
      "li t0, 0x2000\n"  // mstatus.FS: the floating-point unit is on
      "csrs mstatus, t0\n"
      "csrw fcsr, zero\n"
#endif
      "j eagerx_start\n"
      ".option pop\n");
}

// From reset to main on every Cortex-M from M3 on. Sources: ARMv7-M Architecture Reference Manual
// (DDI 0403E) B1.5, B3.2.
#include <cstddef>
#include <cstdint>
#include <targets/common/bare-metal/semihosting.hpp>
#include <targets/common/bare-metal/start.hpp>

int main();

extern "C" {
using Handler = void (*)();

void Fault_Handler();         // faults.cpp
void Unexpected_Interrupt();  // faults.cpp
void SysTick_Handler();       // clock.cpp
void Reset_Handler();
[[noreturn]] void eagerx_start();
}

namespace {

constexpr std::size_t kBoardInterrupts = 64;

struct VectorTable {
  const std::uint32_t* stack_top;
  Handler reset;
  Handler nmi;
  Handler hard_fault;
  Handler memory_fault;
  Handler bus_fault;
  Handler usage_fault;
  Handler others[9 + kBoardInterrupts];  // reserved, SVCall, …, SysTick, then the board's own
};

constexpr VectorTable make_vectors() {
  VectorTable table{.stack_top = eagerx_stack_top,
                    .reset = Reset_Handler,
                    .nmi = Unexpected_Interrupt,
                    .hard_fault = Fault_Handler,
                    .memory_fault = Fault_Handler,
                    .bus_fault = Fault_Handler,
                    .usage_fault = Fault_Handler,
                    .others = {}};
  for (Handler& handler : table.others) handler = Unexpected_Interrupt;
  constexpr std::size_t kSysTick = 15 - 7;
  table.others[kSysTick] = SysTick_Handler;
  return table;
}

[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors = make_vectors();

volatile std::uint32_t& system_register(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

/// Faults get their own handlers, instead of all ending as a hard fault; so does a division by 0.
void name_faults() {
  constexpr std::uintptr_t kVectorTableOffset = 0xE000ED08;
  constexpr std::uintptr_t kConfigurationControl = 0xE000ED14;
  constexpr std::uintptr_t kHandlerControl = 0xE000ED24;
  constexpr std::uint32_t kTrapDivisionByZero = 1U << 4U;
  constexpr std::uint32_t kMemoryBusUsageFaults = 7U << 16U;
  system_register(kVectorTableOffset) = reinterpret_cast<std::uintptr_t>(&vectors);
  system_register(kConfigurationControl) =
      system_register(kConfigurationControl) | kTrapDivisionByZero;
  system_register(kHandlerControl) = system_register(kHandlerControl) | kMemoryBusUsageFaults;
}

/// Forbids the 32 kB below the stack, which is the lowest thing in RAM: running over its end is a
/// fault and not a mystery. Without a memory protection unit there is no guard (ARMv7-M, B3.5).
/// ARMv8-M has a register for the limit itself (DDI 0553B, B3.21).
void guard_stack() {
#if __ARM_ARCH >= 8
  asm volatile("msr msplim, %0" ::"r"(eagerx_stack_bottom) : "memory");
#else
  constexpr std::uintptr_t kType = 0xE000ED90;
  constexpr std::uintptr_t kControl = 0xE000ED94;
  constexpr std::uintptr_t kRegionNumber = 0xE000ED98;
  constexpr std::uintptr_t kRegionBase = 0xE000ED9C;
  constexpr std::uintptr_t kRegionSize = 0xE000EDA0;
  constexpr std::uintptr_t kGuardBytes = 32768;
  constexpr std::uint32_t kSizeOfGuard = 14U << 1U;  // 2^(14+1) bytes, no access rights
  constexpr std::uint32_t kNeverExecute = 1U << 28U;
  constexpr std::uint32_t kEnable = 1U << 0U;
  constexpr std::uint32_t kDefaultMapElsewhere = 1U << 2U;
  const auto bottom = reinterpret_cast<std::uintptr_t>(eagerx_stack_bottom);
  if (system_register(kType) == 0 || bottom % kGuardBytes != 0) return;
  system_register(kRegionNumber) = 0;
  system_register(kRegionBase) = bottom - kGuardBytes;
  system_register(kRegionSize) = kNeverExecute | kSizeOfGuard | kEnable;
  system_register(kControl) = kDefaultMapElsewhere | kEnable;
  asm volatile("dsb\n isb" ::: "memory");
#endif
}

}  // namespace

void eagerx_start() {
  using namespace eagerx::board;
  paint_stack();
  initialise_memory();
  name_faults();
  guard_stack();
  run_constructors();
  semihosting_exit(main());
}

// Naked: the compiler must not touch a floating-point register before the unit is on, not even to
// save it.
[[gnu::naked]] void Reset_Handler() {
#ifdef __ARM_FP
  // CPACR: full access to coprocessors 10 and 11, the floating-point unit.
  asm volatile(
      "ldr r0, =0xE000ED88\n"
      "ldr r1, [r0]\n"
      "orr r1, r1, #0xF00000\n"
      "str r1, [r0]\n"
      "dsb\n"
      "isb\n");
#endif
  asm volatile("bl eagerx_start");
}

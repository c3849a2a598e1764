// Faults switch outputs off, report their cause and end the program. Source: ARMv7-M Architecture
// Reference Manual (DDI 0403E) B3.2.15 to B3.2.18 (fault status registers), B1.5.6 (stacked frame);
// ARMv8-M (DDI 0553B).
#include <cstdint>
#include <eagerx/memory_fault.hpp>
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/bare-metal/semihosting.hpp>
#include <targets/common/bare-metal/stack.hpp>
#include <targets/common/bare-metal/start.hpp>

extern "C" {
void Fault_Handler();
void Unexpected_Interrupt();
[[noreturn, gnu::used]] void eagerx_report_exception(const std::uint32_t* frame,
                                                     std::uint32_t number);
}

namespace {

using eagerx::board::console;

std::uint32_t system_register(std::uintptr_t address) {
  return *reinterpret_cast<const volatile std::uint32_t*>(address);
}

struct Cause {
  std::uint32_t mask;
  const char* text;
};

// Bits of the Configurable Fault Status Register.
constexpr Cause kCauses[] = {
    {1U << 0U, "instruction fetched from memory that holds none"},
    {1U << 1U, "data access that is not allowed"},
    {1U << 4U, "stack overflow"},
    {1U << 8U, "instruction fetched from where there is no memory"},
    {1U << 9U, "access to where there is no memory"},
    {1U << 10U, "access to where there is no memory"},
    {1U << 12U, "stack overflow"},
    {1U << 13U, "stack overflow"},
    {1U << 16U, "undefined instruction"},
    {1U << 17U, "jump to an address that is not Thumb code"},
    {1U << 18U, "broken return from an exception"},
    {1U << 19U, "floating-point unit is off or missing"},
    {1U << 20U, "stack overflow"},  // ARMv8-M
    {1U << 24U, "unaligned access"},
    {1U << 25U, "integer division by zero"},
};

const char* name_of(std::uint32_t number) {
  constexpr const char* kNames[] = {"non-maskable interrupt", "hard fault", "memory fault",
                                    "bus fault", "usage fault"};
  constexpr std::uint32_t kFirst = 2;
  return number - kFirst < std::size(kNames) ? kNames[number - kFirst] : "unexpected interrupt";
}

const char* cause_of(std::uint32_t status) {
  for (const Cause& cause : kCauses) {
    if ((status & cause.mask) != 0) return cause.text;
  }
  return "no cause recorded";
}

}  // namespace

void eagerx_report_exception(const std::uint32_t* frame, std::uint32_t number) {
  if (eagerx_outputs_off != nullptr) eagerx_outputs_off();
  constexpr std::uintptr_t kFaultStatus = 0xE000ED28;
  constexpr std::uint32_t kStackedPc = 6;  // r0 r1 r2 r3 r12 lr pc psr
  constexpr std::uint32_t kFrameWords = 8;
  const std::uint32_t status = system_register(kFaultStatus);
  constexpr std::uint32_t kPastLimit = 1U << 20U;  // ARMv8-M pushes no frame then
  // A frame that fits proves nothing about one that could not be pushed, but it can be read.
  const bool inside = (status & kPastLimit) == 0 && frame >= eagerx_stack_bottom &&
                      frame + kFrameWords <= eagerx_stack_top;
  console.text("error: ");
  console.text(name_of(number));
  console.text(" (exception ");
  console.number(number);
  console.text("): ");
  console.text(inside ? cause_of(status) : "stack overflow");
  console.text(", status 0x");
  console.hex(status);
  if (inside) {
    console.text(", at address 0x");
    console.hex(frame[kStackedPc]);
  }
  console.text("\n");
  console.flush();
  eagerx::board::semihosting_exit(eagerx::board::kFault);
}

// Corrupted memory ends the program like every other fault.
void eagerx_memory_fault() {
  __builtin_trap();
}

// The stack may be what is broken: report on a fresh one, the handler never returns.
[[gnu::naked]] void Fault_Handler() {
  asm volatile(
      "mrs r0, msp\n"
      "mrs r1, ipsr\n"
      "ldr r2, =eagerx_stack_top\n"
      "mov sp, r2\n"
      "b eagerx_report_exception\n");
}

[[gnu::naked]] void Unexpected_Interrupt() {
  asm volatile("b Fault_Handler");
}

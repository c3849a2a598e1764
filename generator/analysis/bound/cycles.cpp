#include "generator/analysis/bound/cycles.hpp"

#include <algorithm>
#include <string>

#include "generator/analysis/bound/flow.hpp"
#include "generator/analysis/bound/operands.hpp"

namespace eagerx::gen::bound {
namespace {

constexpr std::uint64_t kRefill = 3;            // P, 1 to 3
constexpr std::uint64_t kSlowestInteger = 12;   // SDIV and UDIV, 2 to 12
constexpr std::uint64_t kSlowestFloating = 14;  // VDIV and VSQRT
constexpr Address kWordOfCode = 4;

/// Registers of one word that a list of registers names.
std::uint64_t words_of(const std::string& list) {
  if (list.find('d') != std::string::npos) {
    const auto [first, last] = range_of_doubles(list);
    return 2 * (last - first + 1);
  }
  return listed_registers(list).size();
}

bool is_load_of_many(std::string_view name) {
  return starts_with_any(name, {"ldm", "pop", "vldm", "vpop"});
}

/// Words that are read besides code.
std::uint64_t words_read(const Instruction& instruction) {
  if (is_load_of_many(instruction.name)) return words_of(instruction.operands.back());
  if (instruction.name == "ldrd") return 2;
  if (instruction.name == "vldr") return instruction.operands[0].starts_with("d") ? 2 : 1;
  const bool reads = starts_with_any(instruction.name, {"ldr", "tbb", "tbh", "pld"});
  return reads ? 1 : 0;
}

bool is_of_stack(const Instruction& instruction) {
  if (instruction.name == "pop" || instruction.name == "vpop") return true;
  return std::ranges::any_of(instruction.operands, [](const std::string& operand) {
    return operand.starts_with("[sp") || operand == "sp!" || operand == "sp";
  });
}

bool is_quick_integer(std::string_view name, Core core) {
  if (starts_with_any(name, {"mov", "mvn", "add", "adc", "adr",  "sub",  "sbc",  "rsb",  "cmp",
                             "cmn", "tst", "teq", "and", "orr",  "orn",  "eor",  "bic",  "lsl",
                             "lsr", "asr", "ror", "rrx", "rev",  "clz",  "rbit", "uxt",  "sxt",
                             "ubf", "sbf", "bfi", "bfc", "ssat", "usat", "nop",  "clrex"}))
    return true;
  if (name == "mul" || name == "muls" || name == "neg" || name == "negs" || name == "sev")
    return true;
  if (name.starts_with("it") && name.find_first_not_of("te", 1) == std::string_view::npos)
    return true;
  if (name == "b" || name == "cbz" || name == "cbnz") return true;
  // Multiplications of 64 bits and the DSP extension: DDI 0439B, tables 3-1 and 3-2.
  return core == Core::cortex_m4 &&
         starts_with_any(
             name, {"umull", "smull", "umlal", "smlal", "umaal", "mla",   "mls",   "smla",  "smul",
                    "smmul", "smmla", "smmls", "smlsd", "smuad", "smusd", "usad",  "qadd",  "qsub",
                    "qdadd", "qdsub", "sadd",  "ssub",  "uadd",  "usub",  "uhadd", "uhsub", "shadd",
                    "shsub", "uqadd", "uqsub", "sasx",  "ssax",  "uasx",  "usax",  "pkh",   "sel"});
}

/// Results that the next instruction waits a cycle for.
bool is_arithmetic(std::string_view name) {
  return starts_with_any(
      name, {"vadd", "vsub", "vmul", "vnmul", "vdiv", "vsqrt", "vmla", "vmls", "vnmla", "vnmls",
             "vfma", "vfms", "vfnma", "vfnms", "vcvt", "vcmp", "vabs", "vneg"});
}

/// A move from or to core registers.
bool is_of_core(const Instruction& instruction) {
  return std::ranges::any_of(instruction.values,
                             [](const Operand& operand) { return operand.reg < kCore; });
}

/// Whether the result may be an operand of the next instruction; of a jump's target, always.
bool may_use(const Instruction* next, const Instruction& made) {
  if (next == nullptr || next->turn != Turn::none) return true;
  if (!next->name.starts_with("v")) return false;
  if (made.name.starts_with("vcmp")) return next->name == "vmrs";
  return std::ranges::any_of(next->operands, [&](const std::string& operand) {
    return operand == made.operands[0] || operand.starts_with("d") || operand.starts_with("{");
  });
}

}  // namespace

const Cost& instruction_cost() {
  class One : public Cost {
   public:
    [[nodiscard]] std::uint64_t of(const Instruction& /*instruction*/,
                                   const Instruction* /*before*/) const override {
      return 1;
    }
    [[nodiscard]] std::uint64_t taken(const Instruction& /*jump*/) const override { return 0; }
  };
  static const One kOne;
  return kOne;
}

std::optional<Core> core_of(std::string_view cpu) {
  if (cpu == "Cortex-M3") return Core::cortex_m3;
  if (cpu == "Cortex-M4" || cpu == "Cortex-M4F") return Core::cortex_m4;
  return std::nullopt;
}

/// What was fetched beyond a jump is lost, and one fetch may be under way.
std::uint64_t Cycles::refill() const {
  return kRefill + wait_states_;
}

std::uint64_t Cycles::integer(const Instruction& i) const {
  const std::string& name = i.name;
  const Turn turn = i.turn;
  const std::uint64_t leaves = turn == Turn::back || turn == Turn::call_pointer ? refill() : 0;
  if (starts_with_any(name, {"ldm", "pop", "stm", "push"}))
    return 1 + words_of(i.operands.back()) + leaves;
  if (name == "ldrd" || name == "strd") return 3;
  if (starts_with_any(name, {"ldr", "str", "pld"})) return 2 + leaves;
  if (name == "bl" || name == "blx") return 1 + refill();
  if (turn == Turn::back) return 1 + leaves;
  if (name == "tbb" || name == "tbh") return 2;  // taken() has the rest
  if (is_quick_integer(name, core_)) return 1;
  if (starts_with_any(name, {"mla", "mls"})) return 2;
  if (starts_with_any(name, {"umull", "smull"})) return 5;
  if (starts_with_any(name, {"umlal", "smlal"})) return 7;
  if (starts_with_any(name, {"mrs", "msr", "cps"})) return 2;
  if (name == "dmb" || name == "dsb" || name == "isb") return 1 + refill();
  if (name == "wfi" || name == "wfe") return 1;  // waiting is no work
  return kSlowestInteger;
}

std::uint64_t Cycles::floating(const Instruction& i) const {
  const std::string& name = i.name;
  if (starts_with_any(name, {"vldm", "vstm", "vpop", "vpush"}))
    return 1 + words_of(i.operands.back());
  if (name == "vldr" || name == "vstr") return i.operands[0].starts_with("d") ? 3 : 2;
  std::uint64_t own = kSlowestFloating;
  if (starts_with_any(name, {"vmla", "vmls", "vnmla", "vnmls", "vfma", "vfms", "vfnma", "vfnms"})) {
    own = 3;
  } else if (name == "vmov") {
    own = is_of_core(i) ? 2 : 1;
  } else if (starts_with_any(name, {"vadd", "vsub", "vmul", "vnmul", "vabs", "vneg", "vcmp", "vcvt",
                                    "vmrs", "vmsr"})) {
    own = 1;
  }
  return own + (is_arithmetic(name) && may_use(image_.instruction(i.next), i) ? 1 : 0);
}

Cycles::Cycles(const Image& image, Core core, unsigned wait_states)
    : image_(image), core_(core), wait_states_(wait_states) {
  without_fetch_.reserve(image.instructions().size());
  for (const Instruction& instruction : image.instructions())
    without_fetch_.push_back(without_fetch(instruction));
}

std::uint64_t Cycles::without_fetch(const Instruction& i) const {
  std::uint64_t cycles = i.name.starts_with("v") ? floating(i) : integer(i);
  if (wait_states_ > 0 && !is_of_stack(i)) cycles += wait_states_ * words_read(i);
  // The target of a branch that is not taken may have been fetched.
  if (i.turn == Turn::branch) cycles += wait_states_;
  return cycles;
}

std::uint64_t Cycles::of(const Instruction& i, const Instruction* before) const {
  // Words of code, without the one that the instruction before has brought.
  const Address last = (i.next - 1) / kWordOfCode;
  Address first = i.at / kWordOfCode;
  if (before != nullptr && before->next == i.at && (before->next - 1) / kWordOfCode == first)
    ++first;
  return without_fetch_[i.index] + std::uint64_t{wait_states_} * (last + 1 - first);
}

std::uint64_t Cycles::taken(const Instruction& jump) const {
  const Turn turn = jump.turn;
  return turn == Turn::branch ? kRefill : turn == Turn::table ? refill() : 0;
}

std::uint64_t Cycles::exception(std::uint64_t most, bool saves_floats) const {
  constexpr std::uint64_t kEntry = 12;  // DDI 0439B 3.9: with a memory without wait states
  constexpr std::uint64_t kReturn = 12;
  constexpr std::uint64_t kFloats = 17;  // s0 to s15 and FPSCR
  const std::uint64_t vector = wait_states_;
  return kEntry + vector + most + kReturn + refill() + 2 * wait_states_ +
         (saves_floats ? 2 * kFloats : 0);
}

}  // namespace eagerx::gen::bound

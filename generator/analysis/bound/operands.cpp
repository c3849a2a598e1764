#include "generator/analysis/bound/operands.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

namespace eagerx::gen::bound {

std::optional<std::size_t> register_of(std::string_view operand) {
  static constexpr std::array<std::string_view, 8> kNames = {"r8", "r9", "sl", "fp",
                                                             "ip", "sp", "lr", "pc"};
  if (const auto* found = std::ranges::find(kNames, operand); found != kNames.end())
    return static_cast<std::size_t>(found - kNames.begin()) + 8;
  if (operand.size() < 2 || (operand[0] != 'r' && operand[0] != 's')) return std::nullopt;
  std::size_t number = 0;
  const auto result = std::from_chars(operand.data() + 1, operand.data() + operand.size(), number);
  if (result.ec != std::errc() || result.ptr != operand.data() + operand.size())
    return std::nullopt;
  if (operand[0] == 'r') return number < kCore ? std::optional(number) : std::nullopt;
  return number + kCore < kRegisters ? std::optional(number + kCore) : std::nullopt;
}

std::optional<std::int64_t> number_of(std::string_view operand) {
  if (!operand.starts_with("#")) return std::nullopt;
  operand.remove_prefix(1);
  std::int64_t value = 0;
  const auto result = std::from_chars(operand.data(), operand.data() + operand.size(), value);
  if (result.ec != std::errc()) return std::nullopt;
  return value;
}

std::int64_t as_signed(std::int64_t value) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(value));
}

namespace {

std::vector<std::string_view> parts_of(std::string_view list) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const auto comma = std::min(list.find(',', begin), list.size());
    std::string_view part = list.substr(begin, comma - begin);
    while (part.starts_with(' ')) part.remove_prefix(1);
    parts.push_back(part);
    begin = comma + 1;
  }
  return parts;
}

/// The operand in brackets and what is behind it; nullopt: there is none with a known base.
std::optional<Memory> memory_of(const Instruction& instruction) {
  const auto& operands = instruction.operands;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const std::string& text = operands[i];
    if (!text.starts_with("[")) continue;
    const auto close = text.find(']');
    const auto parts = parts_of(std::string_view(text).substr(1, close - 1));
    const auto base = register_of(parts[0]);
    if (!base) return std::nullopt;
    Memory memory{.base = *base, .writes_back = text.ends_with("!")};
    if (parts.size() > 1) {
      const auto number = number_of(parts[1]);
      memory.has_index = !number;
      memory.offset = number.value_or(0);
    }
    if (i + 1 < operands.size()) {
      memory.after = number_of(operands[i + 1]).value_or(0);
      memory.writes_back = true;
    }
    return memory;
  }
  return std::nullopt;
}

/// Whether an instruction of this name sets the flags: "adds", not "mls".
bool is_setter(std::string_view name) {
  static constexpr std::array<std::string_view, 19> kSetters = {
      "adds", "subs", "movs", "ands", "orrs", "eors", "bics", "lsls", "lsrs", "asrs",
      "rsbs", "muls", "mvns", "adcs", "sbcs", "rors", "rrxs", "orns", "negs"};
  return std::ranges::find(kSetters, name) != kSetters.end() || name == "msr";
}

Kind kind_of(std::string_view name) {
  if (name.starts_with("it") || name == "nop") return Kind::nothing;
  if (name == "bkpt" || name == "svc") return Kind::supervisor;
  if (name == "pld" || name == "pli" || name.starts_with("vcmp")) return Kind::nothing;
  if (name == "tst" || name == "teq" || name == "cmn" || name == "cmp") return Kind::compare;
  if (name == "push" || name == "pop" || starts_with_any(name, {"vpush", "vpop"}))
    return Kind::stack;
  return starts_with_any(name, {"ldm", "stm", "vldm", "vstm"}) ? Kind::many : Kind::other;
}

Operation operation_of(std::string_view name) {
  using enum Operation;
  static constexpr std::array<std::pair<std::string_view, Operation>, 21> kOperations = {
      {{"mov", mov}, {"movw", mov}, {"vmov", vmov}, {"movt", movt},   {"mvn", mvn},
       {"add", add}, {"addw", add}, {"sub", sub},   {"subw", sub},    {"rsb", rsb},
       {"neg", neg}, {"lsl", lsl},  {"lsr", lsr},   {"and", bit_and}, {"bic", bic},
       {"orr", orr}, {"mul", mul},  {"ubfx", ubfx}, {"uxtb", uxtb},   {"uxth", uxth},
       {"cmp", cmp}}};
  const auto* found =
      std::ranges::find(kOperations, name, &std::pair<std::string_view, Operation>::first);
  return found == kOperations.end() ? unknown : found->second;
}

Turn turn_of(const Instruction& instruction) {
  const std::string& name = instruction.name;
  const auto operand = [&](std::size_t i) {
    return i < instruction.operands.size() ? instruction.operands[i] : std::string();
  };
  if (name == "b" || name == "cbz" || name == "cbnz") return Turn::branch;
  if (name == "bl") return Turn::call;
  if (name == "blx") return instruction.target != 0 ? Turn::call : Turn::call_pointer;
  if (name == "bx") return operand(0) == "lr" ? Turn::back : Turn::unknown;
  if (name == "tbb" || name == "tbh") return Turn::table;
  if (name == "udf") return Turn::halt;
  const bool loads_many = name == "pop" || name.starts_with("ldm");
  if (loads_many)
    return instruction.operands.back().find("pc") != std::string::npos ? Turn::back : Turn::none;
  if (operand(0) != "pc") return Turn::none;
  if (name == "ldr" && operand(1).starts_with("[sp")) return Turn::back;
  if (name == "mov" && operand(1) == "lr") return Turn::back;
  return Turn::unknown;
}

/// What is loaded or stored.
void complete(Memory& memory, const Instruction& instruction) {
  const std::string_view name = instruction.name;
  if (starts_with_any(name, {"ldrb", "ldrsb", "strb", "ldrexb", "strexb"})) memory.width = 1;
  if (starts_with_any(name, {"ldrh", "ldrsh", "strh", "ldrexh", "strexh"})) memory.width = 2;
  memory.is_signed = name.starts_with("ldrs");
  memory.extends_zero = name.starts_with("ldrb") || name == "ldrh";
  memory.is_exclusive = name.starts_with("strex");
  memory.is_pair = starts_with_any(name, {"ldrd", "strd"});
  memory.is_double = instruction.operands[0].starts_with("d");
}

/// The words of a register of the floating-point unit with 64 bits.
void add_double(std::string_view name, std::vector<std::uint8_t>& to) {
  std::size_t number = kRegisters;
  std::from_chars(name.data() + 1, name.data() + name.size(), number);
  for (std::size_t word = kCore + 2 * number; word <= kCore + 2 * number + 1; ++word) {
    if (word < kRegisters) to.push_back(static_cast<std::uint8_t>(word));
  }
}

/// Registers that an instruction may write that no rule is known of.
std::vector<std::uint8_t> written_by(const Instruction& instruction) {
  const bool is_vector = instruction.name.starts_with("v");
  const bool two = starts_with_any(instruction.name, {"umull", "smull", "umlal", "smlal", "umaal",
                                                      "smlald", "smlsld", "ldrexd"});
  const std::size_t most = is_vector ? 4 : two ? 2 : 1;
  const auto is_core = [&](std::size_t i) { return instruction.values[i].reg < kCore; };
  std::vector<std::uint8_t> written;
  for (std::size_t i = 0; i < std::min(most, instruction.operands.size()); ++i) {
    if (is_vector && instruction.operands[i].starts_with("d"))
      add_double(instruction.operands[i], written);
    const std::uint8_t r = instruction.values[i].reg;
    if (r == Operand::kNoRegister) continue;
    if (is_vector && i > 0 && is_core(i) != is_core(0)) break;
    written.push_back(r);
  }
  return written;
}

/// Of an instruction that moves several registers.
RegisterList list_of(const Instruction& instruction) {
  RegisterList list;
  const std::string_view text = instruction.operands.back();
  list.is_of_doubles = text.starts_with("{d");
  if (list.is_of_doubles) {
    const auto [first, last] = range_of_doubles(text);
    list.first = static_cast<std::uint8_t>(2 * first);
    list.last = static_cast<std::uint8_t>(2 * last + 1);
  } else {
    for (const std::size_t r : listed_registers(text))
      list.registers.push_back(static_cast<std::uint8_t>(r));
  }
  if (instruction.kind != Kind::many) return list;
  const std::string_view first = instruction.operands.front();
  list.writes_back = first.ends_with("!");
  if (const auto r = register_of(first.substr(0, first.size() - (list.writes_back ? 1 : 0))))
    list.base = static_cast<std::uint8_t>(*r);
  list.is_down = instruction.name.ends_with("db");
  list.is_load = starts_with_any(instruction.name, {"ldm", "vldm"});
  return list;
}

}  // namespace

void decode(Instruction& instruction) {
  const std::string_view name = instruction.name;
  instruction.turn = turn_of(instruction);
  instruction.kind = kind_of(name);
  instruction.sets_flags = is_setter(name);
  instruction.operation =
      operation_of(instruction.sets_flags ? name.substr(0, name.size() - 1) : name);
  for (const std::string& text : instruction.operands) {
    Operand operand;
    if (const auto found = register_of(text)) operand.reg = static_cast<std::uint8_t>(*found);
    operand.number = number_of(text);
    instruction.values.push_back(operand);
  }
  if (instruction.kind == Kind::other) instruction.memory = memory_of(instruction);
  if (instruction.memory) {
    complete(*instruction.memory, instruction);
    instruction.kind = starts_with_any(name, {"ldr", "vldr", "tb"}) ? Kind::load : Kind::store;
  }
  instruction.list = list_of(instruction);
  instruction.written = written_by(instruction);
  instruction.writes_flags = instruction.sets_flags || instruction.operands[0] == "APSR_nzcv";
}

bool starts_with_any(std::string_view name, std::initializer_list<std::string_view> beginnings) {
  return std::ranges::any_of(beginnings, [&](auto text) { return name.starts_with(text); });
}

std::vector<std::size_t> listed_registers(std::string_view list) {
  std::vector<std::size_t> registers;
  if (!list.starts_with('{')) return registers;
  list.remove_prefix(1);
  list = list.substr(0, list.find('}'));
  for (const auto part : parts_of(list)) {
    const auto dash = part.find('-');
    const auto first = register_of(part.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : register_of(part.substr(dash + 1));
    if (!first || !last) continue;
    for (std::size_t r = *first; r <= *last; ++r) registers.push_back(r);
  }
  return registers;
}

std::pair<std::size_t, std::size_t> range_of_doubles(std::string_view list) {
  std::size_t first = 0;
  list = list.substr(0, list.find('}'));
  const auto begin = list.find('d') + 1, end = list.rfind('d') + 1;
  std::size_t last = 0;
  std::from_chars(list.data() + begin, list.data() + list.size(), first);
  std::from_chars(list.data() + end, list.data() + list.size(), last);
  constexpr std::size_t kLast = 31;
  return {std::min(first, kLast), std::min(std::max(first, last), kLast)};
}

}  // namespace eagerx::gen::bound

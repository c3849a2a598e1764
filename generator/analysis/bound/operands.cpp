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
    Memory memory{*base, 0, 0, text.ends_with("!"), false};
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
  if (name == "tst" || name == "teq" || name == "cmn" || name == "cmp" || name.starts_with("vcmp"))
    return Kind::compare;
  if (name == "push" || name == "pop" || starts_with_any(name, {"vpush", "vpop"}))
    return Kind::stack;
  return starts_with_any(name, {"ldm", "stm", "vldm", "vstm"}) ? Kind::many : Kind::other;
}

Operation operation_of(std::string_view name) {
  using enum Operation;
  static constexpr std::array<std::pair<std::string_view, Operation>, 20> kOperations = {
      {{"mov", mov}, {"movw", mov}, {"vmov", vmov}, {"movt", movt},   {"mvn", mvn},
       {"add", add}, {"addw", add}, {"sub", sub},   {"subw", sub},    {"rsb", rsb},
       {"neg", neg}, {"lsl", lsl},  {"lsr", lsr},   {"and", bit_and}, {"bic", bic},
       {"orr", orr}, {"mul", mul},  {"ubfx", ubfx}, {"uxtb", uxtb},   {"uxth", uxth}}};
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

}  // namespace

void decode(Instruction& instruction) {
  const std::string_view name = instruction.name;
  instruction.turn = turn_of(instruction);
  instruction.kind = kind_of(name);
  instruction.sets_flags = is_setter(name);
  instruction.operation =
      operation_of(instruction.sets_flags ? name.substr(0, name.size() - 1) : name);
  instruction.memory = memory_of(instruction);
  for (const std::string& text : instruction.operands) {
    Operand operand;
    if (const auto found = register_of(text)) operand.reg = static_cast<std::uint8_t>(*found);
    operand.number = number_of(text);
    instruction.values.push_back(operand);
  }
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

#include "generator/analysis/bound/instruction_text.hpp"

#include <algorithm>
#include <charconv>

#include "generator/analysis/bound/operands.hpp"

namespace eagerx::gen::bound {
namespace {

std::optional<Address> hexadecimal(std::string_view text) {
  constexpr int kHexadecimal = 16;
  if (text.starts_with("0x")) text.remove_prefix(2);
  Address value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value, kHexadecimal);
  if (result.ec != std::errc() || result.ptr == text.data()) return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// At commas outside of brackets.
std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i == text.size() ? ',' : text[i];
    depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    if (c != ',' || (depth > 0 && i < text.size())) continue;
    if (const auto part = trimmed(text.substr(begin, i - begin)); !part.empty())
      parts.emplace_back(part);
    begin = i + 1;
  }
  return parts;
}

/// "beq", "bls", but not "bl" or "bic".
bool is_conditional_branch(std::string_view name) {
  return name.size() == 3 && name[0] == 'b' && condition_named(name.substr(1)).has_value();
}

/// Where a branch leads, or what a load from the code reads: "2650 <name>", "@ (2650 <name>)".
Address target_of(const Instruction& instruction, std::string_view comment) {
  if (!comment.empty()) {
    if (comment.front() == '(') comment.remove_prefix(1);
    return hexadecimal(comment).value_or(0);
  }
  if (instruction.operands.empty()) return 0;
  const std::string_view last = instruction.operands.back();
  const auto space = last.find(" <");
  return space == std::string_view::npos ? 0 : hexadecimal(last.substr(0, space)).value_or(0);
}

}  // namespace

std::optional<Condition> condition_named(std::string_view name) {
  static constexpr std::string_view kNames = "eqnecsccmiplvsvchilsgeltgtleal";
  if (name == "hs") return Condition::cs;
  if (name == "lo") return Condition::cc;
  for (std::size_t i = 0; i < kNames.size(); i += 2) {
    if (name == kNames.substr(i, 2)) return static_cast<Condition>(i / 2);
  }
  return std::nullopt;
}

std::optional<Instruction> InstructionReader::line(std::string_view text) {
  data_.reset();
  text = trimmed(text);
  const auto colon = text.find(":\t");
  if (colon == std::string_view::npos) return std::nullopt;
  const auto at = hexadecimal(text.substr(0, colon));
  if (!at) return std::nullopt;
  text = trimmed(text.substr(colon + 2));
  const auto tab = text.find_first_of(" \t");
  std::string_view name = text.substr(0, tab);
  if (name.empty() || name.front() == '.') {
    data_ = at;
    return std::nullopt;
  }
  std::string_view rest = tab == std::string_view::npos ? "" : text.substr(tab);
  std::string_view comment;
  for (const std::string_view mark : {"@ ", "; "}) {
    if (const auto found = rest.find(mark); found != std::string_view::npos) {
      comment = trimmed(rest.substr(found + 2));
      rest = rest.substr(0, found);
    }
  }
  Instruction instruction;
  instruction.at = *at;
  instruction.name = name.substr(0, name.find('.'));
  instruction.operands = split(rest);
  if (instruction.operands.empty()) instruction.operands.emplace_back();  // there is always a first
  const bool from_code = rest.find("[pc") != std::string_view::npos;
  instruction.target = target_of(instruction, from_code ? comment : std::string_view());
  condition(instruction);
  decode(instruction);
  return instruction;
}

void InstructionReader::condition(Instruction& instruction) {
  std::string& name = instruction.name;
  if (name.starts_with("it") && name.find_first_not_of("te", 1) == std::string::npos) {
    conditional_ = static_cast<unsigned>(name.size()) - 1;
    return;
  }
  const bool in_block = conditional_ > 0;
  if (in_block) --conditional_;
  if (!in_block && !is_conditional_branch(name)) return;
  if (name.size() < 3) return;
  const auto found = condition_named(std::string_view(name).substr(name.size() - 2));
  if (!found) return;
  instruction.condition = *found;
  name.resize(name.size() - 2);
}

}  // namespace eagerx::gen::bound

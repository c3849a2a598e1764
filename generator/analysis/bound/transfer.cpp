#include <algorithm>
#include <bit>
#include <charconv>
#include <vector>

#include "generator/analysis/bound/flow.hpp"
#include "generator/analysis/bound/operands.hpp"
#include "generator/analysis/bound/trips.hpp"
#include "generator/analysis/bound/value.hpp"

namespace eagerx::gen::bound {

namespace {

/// The effect of an instruction on the values; one object for each.
class Step {
 public:
  Step(const Image& image, const Instruction& instruction, State& state)
      : image_(image), instruction_(instruction), name_(instruction.name), state_(state) {}

  void apply() {
    const Turn turn = turn_of(instruction_);
    if (turn == Turn::call || turn == Turn::call_pointer) return call();
    if (turn == Turn::branch || turn == Turn::table || turn == Turn::halt) return;
    if (name_.starts_with("it") || name_ == "nop") return;
    if (name_ == "bkpt" || name_ == "svc") return supervisor();
    if (compare()) return;
    if (name_ == "push" || name_ == "pop" || starts_with_any(name_, {"vpush", "vpop"}))
      return move_stack();
    if (starts_with_any(name_, {"ldm", "stm", "vldm", "vstm"})) return transfer_many();
    if (const auto memory = memory_of(instruction_)) return access(*memory);
    if (calculate()) return;
    forget_written();
  }

 private:
  [[nodiscard]] std::string_view operand(std::size_t i) const {
    return i < instruction_.operands.size() ? std::string_view(instruction_.operands[i])
                                            : std::string_view();
  }

  Value made(std::size_t r) const {
    return {base_of(Origin::made, instruction_.at, {false, static_cast<std::int64_t>(r)}), 0, 0};
  }

  void write(std::size_t r, const std::optional<Value>& value) {
    const Value old = state_.registers[r];
    state_.registers[r] = value && instruction_.condition.empty() ? *value : made(r);
    if (!instruction_.condition.empty() && value) limit_either(r, *value, old);
    if (r < kCore && state_.registers[r].base == kStack && r != kSp)
      state_.escaped = std::min(state_.escaped, state_.registers[r].low);
  }

  /// A register that an instruction writes only under its condition: what it is between. So
  /// `cmp r3, #5`, `it cs`, `movcs r3, #5` is a number up to 5.
  void limit_either(std::size_t r, const Value& value, const Value& old) {
    State when = state_, otherwise = state_;
    if (state_.comparison) {
      when.learn(instruction_.condition, *state_.comparison);
      otherwise.learn(opposite(instruction_.condition), *state_.comparison);
    }
    const Value a = when.resolve(value), b = otherwise.resolve(old);
    state_.limits.erase(made(r).base);
    if (a.base == 0 && b.base == 0)
      state_.limits[made(r).base] = {0, std::min(a.low, b.low), std::max(a.high, b.high)};
  }

  void forget_written() {
    const bool two = starts_with_any(
        name_, {"umull", "smull", "umlal", "smlal", "umaal", "smlald", "smlsld", "ldrexd"});
    if (sets_flags(name_)) state_.comparison.reset();
    const bool is_vector = name_.starts_with("v");
    for (std::size_t i = 0; i < instruction_.operands.size(); ++i) {
      if (i >= (is_vector ? 4U : two ? 2U : 1U)) break;
      const auto r = register_of(operand(i));
      if (is_vector && operand(i).starts_with("d")) forget_double(operand(i));
      if (!r) continue;
      if (is_vector && i > 0 && (*r < kCore) != (register_of(operand(0)).value_or(kCore) < kCore))
        break;
      write(*r, std::nullopt);
    }
    if (operand(0) == "APSR_nzcv") state_.comparison.reset();
  }

  void forget_double(std::string_view name) {
    std::size_t number = kRegisters;
    std::from_chars(name.data() + 1, name.data() + name.size(), number);
    for (std::size_t i = 0; i < 2; ++i) {
      if (kCore + 2 * number + i < kRegisters) write(kCore + 2 * number + i, std::nullopt);
    }
  }

  [[nodiscard]] std::optional<Value> read(std::string_view text) const {
    if (const auto number = number_of(text)) return Value::of(as_signed(*number));
    const auto r = register_of(text);
    return r && *r != kCore - 1 ? std::optional(state_.registers[*r]) : std::nullopt;
  }

  bool compare() {
    if (name_ == "tst" || name_ == "teq" || name_ == "cmn") {
      state_.comparison.reset();
      return true;
    }
    if (name_ != "cmp") return starts_with_any(name_, {"vcmp"});
    const auto left = read(operand(0)), right = read(operand(1));
    state_.comparison.reset();
    if (left && right && instruction_.operands.size() == 2 && instruction_.condition.empty())
      state_.comparison = Comparison{*left, *right, false};
    return true;
  }

  void call() {
    // A part of a function, which assembly calls, preserves nothing.
    const bool is_function = image_.functions().contains(instruction_.target) ||
                             turn_of(instruction_) == Turn::call_pointer;
    for (std::size_t r = 0; r < kCore; ++r) {
      if (r != kSp && (!is_function || r < 4 || r == 12 || r == 14)) write(r, std::nullopt);
    }
    for (std::size_t s = 0; s < (is_function ? kCore : kRegisters - kCore); ++s)
      write(kCore + s, std::nullopt);
    state_.comparison.reset();
    forget_stack();
    const Value& sp = state_.registers[kSp];
    if (sp.base != kStack) return state_.stack.clear();
    std::erase_if(state_.stack, [&](const auto& slot) { return slot.first < sp.low; });
  }

  /// Semihosting answers in r0, and may write where a pointer leads.
  void supervisor() {
    write(0, std::nullopt);
    forget_stack();
  }

  /// A write through a pointer that is not known: it may lead to what has its address taken.
  void forget_stack() {
    for (auto& [offset, value] : state_.stack) {
      if (offset >= state_.escaped)
        value = {base_of(Origin::made, instruction_.at, {true, offset}), 0, 0};
    }
  }

  void move_stack() {
    const auto& list = instruction_.operands.back();
    std::int64_t bytes = 0;
    const auto registers =
        list.starts_with("{d") ? std::vector<std::size_t>() : listed_registers(list);
    bytes = static_cast<std::int64_t>(registers.size()) * kWordBytes;
    if (list.starts_with("{d")) bytes = doubles(list) * 2 * kWordBytes;
    const bool pushes = name_ == "push" || name_ == "vpush";
    Value& sp = state_.registers[kSp];
    if (pushes) {
      sp.low -= bytes;
      sp.high -= bytes;
      std::int64_t at = sp.low;
      for (const std::size_t r : registers) {
        store(Value{sp.base, at, at}, 4, state_.registers[r]);
        at += kWordBytes;
      }
      if (registers.empty()) forget_words(sp.low, bytes);
      return;
    }
    std::int64_t at = sp.low;
    for (const std::size_t r : registers) {
      if (r != kCore - 1) write(r, load(Value{sp.base, at, at}, 4));
      at += kWordBytes;
    }
    if (list.starts_with("{d")) forget_doubles(list);
    sp.low += bytes;
    sp.high += bytes;
  }

  static std::int64_t doubles(std::string_view list) {
    const auto [first, last] = range_of_doubles(list);
    return static_cast<std::int64_t>(last - first + 1);
  }
  void forget_doubles(std::string_view list) {
    const auto [first, last] = range_of_doubles(list);
    for (std::size_t s = 2 * first; s <= 2 * last + 1 && kCore + s < kRegisters; ++s)
      write(kCore + s, std::nullopt);
  }

  void forget_words(std::int64_t begin, std::int64_t bytes) {
    for (std::int64_t at = begin; at < begin + bytes; at += kWordBytes) state_.stack.erase(at);
  }

  void transfer_many() {
    const auto& list = instruction_.operands.back();
    const auto& first = instruction_.operands.front();
    const bool writes_back = first.ends_with("!");
    const auto base = register_of(std::string_view(first).substr(0, first.size() - writes_back));
    if (!base) return;
    const bool is_double = list.starts_with("{d");
    const auto registers = is_double ? std::vector<std::size_t>() : listed_registers(list);
    const std::int64_t bytes = is_double ? doubles(list) * 2 * kWordBytes
                                         : static_cast<std::int64_t>(registers.size()) * kWordBytes;
    const bool down = name_.ends_with("db");
    const Value old = state_.registers[*base];
    const Value begin = down ? Value{old.base, old.low - bytes, old.high - bytes} : old;
    const bool loads = starts_with_any(name_, {"ldm", "vldm"});
    for (std::size_t i = 0; i < registers.size(); ++i) {
      const auto shift = static_cast<std::int64_t>(i) * kWordBytes;
      const Value at{begin.base, begin.low + shift, begin.high + shift};
      if (!loads)
        store(at, 4, state_.registers[registers[i]]);
      else if (registers[i] != kCore - 1)
        write(registers[i], load(at, 4));
    }
    if (is_double && loads) forget_doubles(list);
    if (is_double && !loads) store_unknown(begin, bytes);
    if (!writes_back) return;
    write(*base, down ? begin : Value{old.base, old.low + bytes, old.high + bytes});
  }

  /// Bytes that are loaded or stored.
  [[nodiscard]] unsigned width() const {
    if (starts_with_any(name_, {"ldrb", "ldrsb", "strb", "ldrexb", "strexb"})) return 1;
    if (starts_with_any(name_, {"ldrh", "ldrsh", "strh", "ldrexh", "strexh"})) return 2;
    return 4;
  }

  void access(const Memory& memory) {
    if (name_ == "pld" || name_ == "pli") return;
    const std::optional<Value> base =
        memory.base == kCore - 1 ? std::nullopt : std::optional(state_.registers[memory.base]);
    std::optional<Value> at;
    if (memory.base == kCore - 1 && instruction_.target != 0)
      at = Value::of(instruction_.target);
    else if (base && !memory.has_index)
      at = sum(*base, Value::of(memory.offset), 1);
    if (starts_with_any(name_, {"ldr", "vldr", "tb"}))
      load_registers(at);
    else
      store_registers(at, base);
    if (!memory.writes_back || !base) return;
    write(memory.base, sum(*base, Value::of(memory.offset + memory.after), 1));
  }

  void load_registers(const std::optional<Value>& at) {
    if (operand(0).starts_with("d")) return forget_double(operand(0));
    const bool two = name_.starts_with("ldrd");
    for (std::size_t i = 0; i < (two ? 2U : 1U); ++i) {
      const auto r = register_of(operand(i));
      if (!r || *r == kCore - 1) continue;
      std::optional<Value> value;
      if (at)
        value = load(*sum(*at, Value::of(static_cast<std::int64_t>(i) * kWordBytes), 1), width());
      if (!value && name_.starts_with("ldrb")) value = of_bits(8);
      if (!value && name_ == "ldrh") value = of_bits(16);
      write(*r, value);
    }
  }

  [[nodiscard]] std::optional<Value> load(const Value& at, unsigned size) const {
    if (!at.is_exact()) return std::nullopt;
    if (at.base == kStack) {
      const auto found = state_.stack.find(at.low);
      if (size != 4 || found == state_.stack.end()) return std::nullopt;
      return found->second;
    }
    if (at.base != 0 || name_.starts_with("ldrs")) return std::nullopt;
    const auto bytes = image_.constant(static_cast<Address>(at.low), size);
    return bytes ? std::optional(Value::of(as_signed(*bytes))) : std::nullopt;
  }

  void store_registers(const std::optional<Value>& at, const std::optional<Value>& base) {
    if (name_.starts_with("strex")) {
      if (const auto r = register_of(operand(0))) write(*r, std::nullopt);
      return store_unknown(base.value_or(Value{~Base{0}, 0, 0}), 8);
    }
    if (!at || operand(0).starts_with("d"))
      return store_unknown(at.value_or(base.value_or(Value{~Base{0}, 0, 0})), at ? 8 : 0);
    const bool two = name_.starts_with("strd");
    for (std::size_t i = 0; i < (two ? 2U : 1U); ++i) {
      const auto r = register_of(operand(i));
      const Value where = *sum(*at, Value::of(static_cast<std::int64_t>(i) * kWordBytes), 1);
      store(where, width(), r ? state_.registers[*r] : Value{~Base{0}, 0, 0});
    }
  }

  void store(const Value& at, unsigned size, const Value& value) {
    if (at.base != kStack || !at.is_exact())
      return store_unknown(at, at.high - at.low + static_cast<std::int64_t>(size));
    forget_around(at.low, size);
    if (size != 4) return;
    Value& slot = state_.stack[at.low];
    slot = instruction_.condition.empty()
               ? value
               : Value{base_of(Origin::made, instruction_.at, {true, at.low}), 0, 0};
    if (value.base == kStack) state_.escaped = std::min(state_.escaped, value.low);
  }

  /// bytes 0: not known how far.
  void store_unknown(const Value& at, std::int64_t bytes) {
    if (at.base != kStack) {
      if (at.base != 0) forget_stack();
      return;
    }
    if (bytes > 0) return forget_around(at.low, bytes + at.high - at.low);
    std::erase_if(state_.stack, [&](const auto& slot) { return slot.first >= at.low; });
  }

  void forget_around(std::int64_t at, std::int64_t bytes) {
    std::erase_if(state_.stack, [&](const auto& slot) {
      return slot.first + kWordBytes > at && slot.first < at + bytes;
    });
  }

  bool calculate() {
    const auto destination = register_of(operand(0));
    if (!destination || instruction_.operands.size() < 2) return false;
    const bool flags = sets_flags(name_);
    const std::string_view name = flags ? name_.substr(0, name_.size() - 1) : name_;
    std::optional<Value> value;
    if (!result(name, value)) return false;
    const auto before = flags ? comparison_of(name, value) : std::nullopt;
    write(*destination, value);
    if (!flags) return true;
    state_.comparison = instruction_.condition.empty() ? before : std::nullopt;
    if (!state_.comparison && instruction_.condition.empty())
      state_.comparison = Comparison{state_.registers[*destination], Value::of(0), true};
    return true;
  }

  /// The operands that the flags compare: subs its two operands, others the result with 0.
  [[nodiscard]] std::optional<Comparison> comparison_of(std::string_view name,
                                                        const std::optional<Value>& value) const {
    if (name == "sub") {
      const auto [left, right] = two_operands();
      if (left && right) return Comparison{*left, *right, false};
    }
    if (!value) return std::nullopt;
    return Comparison{*value, Value::of(0), true};
  }

  [[nodiscard]] std::pair<std::optional<Value>, std::optional<Value>> two_operands() const {
    const bool three = instruction_.operands.size() >= 3;
    return {read(operand(three ? 1 : 0)), shifted(three ? 2 : 1)};
  }

  /// "r3" or "r3, lsl #2".
  [[nodiscard]] std::optional<Value> shifted(std::size_t i) const {
    auto value = read(operand(i));
    if (instruction_.operands.size() <= i + 1 || !value) return value;
    if (!operand(i + 1).starts_with("lsl ")) return std::nullopt;
    return scaled(*value, number_of(operand(i + 1).substr(4)));
  }

  /// A number of its own with these bits.
  [[nodiscard]] std::optional<Value> of_bits(unsigned bits) const {
    const auto r = register_of(operand(0));
    if (!r || bits > 31) return std::nullopt;
    const Location where{false, static_cast<std::int64_t>(*r)};
    return Value{base_of_bits(instruction_.at, where, bits), 0, 0};
  }

  [[nodiscard]] std::optional<Value> scaled(const Value& unscaled,
                                            std::optional<std::int64_t> shift) const {
    const Value value = state_.resolve(unscaled);
    if (!shift || *shift < 0 || *shift > 31 || value.base != 0 || value.low < 0)
      return std::nullopt;
    const Value result{0, value.low << *shift, value.high << *shift};
    return result.high <= INT32_MAX ? std::optional(result) : std::nullopt;
  }

  /// False: not an operation that is known. An empty value: its result is not known.
  bool result(std::string_view name, std::optional<Value>& value) const {
    const auto [left, right] = two_operands();
    if (name == "mov" && instruction_.operands.size() == 3) {
      const std::string_view shift = operand(2);
      const auto from = read(operand(1));
      const auto by = shift.size() > 4 ? number_of(shift.substr(4)) : std::nullopt;
      if (!by) return false;
      return bits(shift.substr(0, 3), from, Value::of(*by), value);
    }
    if (name == "mov" || name == "movw" || name == "vmov") {
      if (instruction_.operands.size() != 2) return false;
      if (name == "vmov" && !register_of(operand(1))) return false;  // a float's bits
      value = read(operand(1));
    } else if (name == "movt") {
      const auto low = read(operand(0)), high = read(operand(1));
      if (low && high && low->is_number())
        value = Value::of(as_signed((low->low & 0xffff) | (high->low << 16)));
    } else if (name == "mvn") {
      if (right && right->is_number() && instruction_.operands.size() == 2)
        value = Value::of(as_signed(~right->low));
    } else if (name == "add" || name == "addw") {
      if (left && right) value = sum(*left, *right, 1);
    } else if (name == "sub" || name == "subw") {
      if (left && right) value = sum(*left, *right, -1);
    } else if (name == "rsb" || name == "neg") {
      if (left && right)
        value = name == "neg" ? sum(Value::of(0), *right, -1) : sum(*right, *left, -1);
    } else {
      return bits(name, left, right, value);
    }
    return true;
  }

  bool bits(std::string_view name, const std::optional<Value>& left,
            const std::optional<Value>& right, std::optional<Value>& value) const {
    const bool numbers = left && right && left->is_number() && right->is_number();
    if (name == "lsl") {
      if (left && right && right->is_number()) value = scaled(*left, right->low);
    } else if (name == "lsr") {
      const auto from = left ? std::optional(state_.resolve(*left)) : left;
      const bool shifts = right && right->is_number() && right->low > 0 && right->low < 32;
      if (shifts && from && from->base == 0 && from->low >= 0)
        value = Value{0, from->low >> right->low, from->high >> right->low};
      else if (shifts)
        value = of_bits(static_cast<unsigned>(32 - right->low));
    } else if (name == "and") {
      if (numbers)
        value = Value::of(left->low & right->low);
      else if (right && right->is_number() && right->low >= 0)
        value =
            of_bits(static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(right->low))));
    } else if (name == "bic") {
      if (numbers) value = Value::of(left->low & ~right->low);
    } else if (name == "orr") {
      if (numbers) value = Value::of(left->low | right->low);
    } else if (name == "mul") {
      if (numbers) value = Value::of(as_signed(left->low * right->low));
    } else if (name == "ubfx") {
      if (const auto width = number_of(operand(3)); width && *width < 31)
        value = of_bits(static_cast<unsigned>(*width));
    } else if (name == "uxtb" || name == "uxth") {
      const unsigned width = name == "uxtb" ? 8 : 16;
      value = of_bits(width);
      const auto from = right ? state_.resolve(*right) : Value{~Base{0}, 0, 0};
      if (from.base == 0 && from.low >= 0 && from.high < (std::int64_t{1} << width)) value = right;
    } else {
      return false;
    }
    return true;
  }

  const Image& image_;
  const Instruction& instruction_;
  std::string_view name_;
  State& state_;
};

}  // namespace

void apply(const Image& image, const Instruction& instruction, State& state) {
  Step(image, instruction, state).apply();
}

}  // namespace eagerx::gen::bound

#include <algorithm>
#include <vector>

#include "generator/analysis/bound/calculation.hpp"
#include "generator/analysis/bound/operands.hpp"
#include "generator/analysis/bound/value.hpp"

namespace eagerx::gen::bound {

namespace {

/// The effect of an instruction on the values; one object for each.
class Step : Calculation {
 public:
  Step(const Image& image, const Instruction& instruction, State& state, Sums& sums)
      : Calculation(instruction, state, sums),
        image_(image),
        instruction_(instruction),
        state_(state),
        sums_(sums) {}

  void apply() {
    const Turn turn = instruction_.turn;
    if (turn == Turn::call || turn == Turn::call_pointer) return call();
    if (turn == Turn::branch || turn == Turn::table || turn == Turn::halt) return;
    switch (instruction_.kind) {
      case Kind::nothing:
        return;
      case Kind::supervisor:
        return supervisor();
      case Kind::compare:
        return compare();
      case Kind::stack:
        return move_stack();
      case Kind::many:
        return transfer_many();
      case Kind::load:
      case Kind::store:
        return access(*instruction_.memory);
      case Kind::other:
        if (!calculate()) forget_written();
        return;
    }
  }

 private:
  Value made(std::size_t r) const {
    return {base_of(Origin::made, instruction_.at, {false, static_cast<std::int64_t>(r)}), 0, 0};
  }

  void write(std::size_t r, const std::optional<Value>& value) {
    const Value old = state_.registers[r];
    const bool is_conditional = instruction_.is_conditional();
    state_.registers[r] = value && !is_conditional ? *value : made(r);
    if (is_conditional && value)
      choose(r, *value, old);
    else if (state_.choice && state_.choice->at == r)
      state_.choice.reset();
    if (r < kCore && r != kSp) escape(state_.registers[r]);
  }

  /// `ite eq`, `moveq r7, #2`, `movne r7, #3` is one of two numbers, whatever r7 was.
  void choose(std::size_t r, const Value& value, const Value& old) {
    const bool is_second = state_.choice && state_.choice->at == r &&
                           state_.choice->condition == opposite(instruction_.condition);
    limit_either(r, value, is_second ? state_.choice->value : old);
    state_.choice = Choice{r, instruction_.condition, value};
  }

  /// The address of a word of the stack is where others may find it. Objects of this function lie
  /// below what its caller has put there.
  void escape(const Value& value) {
    if (value.base != kStack) return;
    if (value.high >= 0) state_.arguments_escaped = true;
    if (value.low < 0) state_.escaped = std::min(state_.escaped, value.low);
  }

  /// A register that an instruction writes only under its condition: what it is between. So
  /// `cmp r3, #5`, `it cs`, `movcs r3, #5` is a number up to 5.
  void limit_either(std::size_t r, const Value& value, const Value& old) {
    const Value a = resolved_where(instruction_.condition, value);
    const Value b = resolved_where(opposite(instruction_.condition), old);
    state_.limits.erase(made(r).base);
    if (a.base == 0 && b.base == 0)
      state_.limits[made(r).base] = {0, std::min(a.low, b.low), std::max(a.high, b.high)};
  }

  /// What a value is where a condition of the last comparison holds.
  Value resolved_where(Condition condition, const Value& value) {
    const auto fact =
        state_.comparison ? state_.learned(condition, *state_.comparison) : std::nullopt;
    if (!fact) return state_.resolve(value);
    const auto known = state_.limits.find(fact->first);
    const auto before = known == state_.limits.end() ? std::nullopt : std::optional(known->second);
    state_.limits[fact->first] = fact->second;
    const Value result = state_.resolve(value);
    if (before)
      state_.limits[fact->first] = *before;
    else
      state_.limits.erase(fact->first);
    return result;
  }

  void forget_flags() {
    state_.comparison.reset();
    state_.choice.reset();
  }

  void forget_written() {
    if (instruction_.writes_flags) forget_flags();
    for (const std::size_t r : instruction_.written) write(r, std::nullopt);
  }

  void compare() {
    const auto left = read(0), right = read(1);
    forget_flags();
    if (instruction_.operation == Operation::cmp && left && right &&
        instruction_.operands.size() == 2 && !instruction_.is_conditional())
      state_.comparison = Comparison{*left, *right, false};
  }

  void call() {
    // A part of a function, which assembly calls, preserves nothing.
    const bool is_function =
        image_.functions().contains(instruction_.target) || instruction_.turn == Turn::call_pointer;
    const Value first = state_.registers[0];
    for (std::size_t r = 0; r < kCore; ++r) {
      if (r != kSp && (!is_function || r < 4 || r == 12 || r == 14)) write(r, std::nullopt);
    }
    if (returns_first_argument()) write(0, first);
    for (std::size_t s = 0; s < (is_function ? kCore : kRegisters - kCore); ++s)
      write(kCore + s, std::nullopt);
    forget_flags();
    forget_stack();
    const Value& sp = state_.registers[kSp];
    if (sp.base != kStack) return state_.stack.clear();
    state_.stack.erase_if([&](const auto& slot) { return slot.first < sp.low; });
  }

  /// Those of C which do, which compilers rely on (ISO C 7.24.2, 7.24.6).
  [[nodiscard]] bool returns_first_argument() const {
    const auto callee = image_.functions().find(instruction_.target);
    if (instruction_.turn != Turn::call || callee == image_.functions().end()) return false;
    const std::string& name = callee->second;
    return name == "memcpy" || name == "memmove" || name == "memset";
  }

  /// Semihosting answers in r0, and may write where a pointer leads.
  void supervisor() {
    write(0, std::nullopt);
    forget_stack();
  }

  /// A write through a pointer that is not known: it may lead to what has its address taken.
  void forget_stack() {
    for (auto& [offset, value] : state_.stack) {
      if (offset >= 0 ? state_.arguments_escaped : offset >= state_.escaped)
        value = {base_of(Origin::made, instruction_.at, {true, offset}), 0, 0};
    }
  }

  void move_stack() {
    const RegisterList& list = instruction_.list;
    const std::int64_t bytes = bytes_of(list);
    const bool pushes = instruction_.name.ends_with("push");
    Value& sp = state_.registers[kSp];
    if (pushes) {
      sp.low -= bytes;
      sp.high -= bytes;
      std::int64_t at = sp.low;
      for (const std::size_t r : list.registers) {
        store(Value{sp.base, at, at}, 4, state_.registers[r]);
        at += kWordBytes;
      }
      if (list.registers.empty()) forget_words(sp.low, bytes);
      return;
    }
    std::int64_t at = sp.low;
    for (const std::size_t r : list.registers) {
      if (r != kCore - 1) write(r, load(Value{sp.base, at, at}, 4));
      at += kWordBytes;
    }
    if (list.is_of_doubles) forget_doubles(list);
    sp.low += bytes;
    sp.high += bytes;
  }

  static std::int64_t bytes_of(const RegisterList& list) {
    const std::size_t words =
        list.is_of_doubles ? std::size_t{list.last} - list.first + 1 : list.registers.size();
    return static_cast<std::int64_t>(words) * kWordBytes;
  }
  void forget_doubles(const RegisterList& list) {
    for (std::size_t s = list.first; s <= list.last && kCore + s < kRegisters; ++s)
      write(kCore + s, std::nullopt);
  }

  void forget_words(std::int64_t begin, std::int64_t bytes) {
    for (std::int64_t at = begin; at < begin + bytes; at += kWordBytes) state_.stack.erase(at);
  }

  void transfer_many() {
    const RegisterList& list = instruction_.list;
    if (!list.base) return;
    const std::int64_t bytes = bytes_of(list);
    const Value old = state_.registers[*list.base];
    const Value begin = list.is_down ? Value{old.base, old.low - bytes, old.high - bytes} : old;
    for (std::size_t i = 0; i < list.registers.size(); ++i) {
      const auto shift = static_cast<std::int64_t>(i) * kWordBytes;
      const Value at{begin.base, begin.low + shift, begin.high + shift};
      if (!list.is_load)
        store(at, 4, state_.registers[list.registers[i]]);
      else if (list.registers[i] != kCore - 1)
        write(list.registers[i], load(at, 4));
    }
    if (list.is_of_doubles && list.is_load) forget_doubles(list);
    if (list.is_of_doubles && !list.is_load) store_unknown(begin, bytes);
    if (!list.writes_back) return;
    write(*list.base, list.is_down ? begin : Value{old.base, old.low + bytes, old.high + bytes});
  }

  void access(const Memory& memory) {
    const std::optional<Value> base =
        memory.base == kCore - 1 ? std::nullopt : std::optional(state_.registers[memory.base]);
    std::optional<Value> at;
    if (memory.base == kCore - 1 && instruction_.target != 0)
      at = Value::of(instruction_.target);
    else if (base && !memory.has_index)
      at = sum(*base, Value::of(memory.offset), 1);
    if (instruction_.kind == Kind::load)
      load_registers(memory, at);
    else
      store_registers(memory, at, base);
    if (!memory.writes_back || !base) return;
    write(memory.base, sum(*base, Value::of(memory.offset + memory.after), 1));
  }

  void load_registers(const Memory& memory, const std::optional<Value>& at) {
    if (memory.is_double) {
      for (const std::size_t r : instruction_.written) write(r, std::nullopt);
      return;
    }
    for (std::size_t i = 0; i < (memory.is_pair ? 2U : 1U); ++i) {
      const auto r = register_at(i);
      if (!r || *r == kCore - 1) continue;
      std::optional<Value> value;
      if (at)
        value =
            load(*sum(*at, Value::of(static_cast<std::int64_t>(i) * kWordBytes), 1), memory.width);
      if (!value && memory.extends_zero) value = of_bits(8 * memory.width);
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
    const bool is_signed = instruction_.memory && instruction_.memory->is_signed;
    if (at.base != 0 || is_signed) return std::nullopt;
    const auto bytes = image_.constant(static_cast<Address>(at.low), size);
    return bytes ? std::optional(Value::of(as_signed(*bytes))) : std::nullopt;
  }

  void store_registers(const Memory& memory, const std::optional<Value>& at,
                       const std::optional<Value>& base) {
    if (memory.is_exclusive) {
      if (const auto r = register_at(0)) write(*r, std::nullopt);
      return store_unknown(base.value_or(Value{~Base{0}, 0, 0}), 8);
    }
    if (!at || memory.is_double)
      return store_unknown(at.value_or(base.value_or(Value{~Base{0}, 0, 0})), at ? 8 : 0);
    for (std::size_t i = 0; i < (memory.is_pair ? 2U : 1U); ++i) {
      const auto r = register_at(i);
      const Value where = *sum(*at, Value::of(static_cast<std::int64_t>(i) * kWordBytes), 1);
      store(where, memory.width, r ? state_.registers[*r] : Value{~Base{0}, 0, 0});
    }
  }

  void store(const Value& at, unsigned size, const Value& value) {
    if (at.base != kStack || !at.is_exact())
      return store_unknown(at, at.high - at.low + static_cast<std::int64_t>(size));
    forget_around(at.low, size);
    if (size != 4) return;
    Value& slot = state_.stack[at.low];
    slot = instruction_.is_conditional()
               ? Value{base_of(Origin::made, instruction_.at, {true, at.low}), 0, 0}
               : value;
    escape(value);
  }

  /// bytes 0: not known how far.
  void store_unknown(const Value& at, std::int64_t bytes) {
    if (at.base != kStack) {
      if (at.base != 0) forget_stack();
      return;
    }
    if (bytes > 0) return forget_around(at.low, bytes + at.high - at.low);
    state_.stack.erase_if([&](const auto& slot) { return slot.first >= at.low; });
  }

  void forget_around(std::int64_t at, std::int64_t bytes) {
    state_.stack.erase_if(
        [&](const auto& slot) { return slot.first + kWordBytes > at && slot.first < at + bytes; });
  }

  bool calculate() {
    const auto destination = register_at(0);
    if (!destination || instruction_.operands.size() < 2) return false;
    std::optional<Value> value;
    if (!result(value)) return false;
    const auto before = instruction_.sets_flags ? comparison_of(value) : std::nullopt;
    write(*destination, value);
    const bool is_conditional = instruction_.is_conditional();
    if (value && !is_conditional) keep_apart(*destination, *value);
    if (!instruction_.sets_flags) return true;
    state_.choice.reset();
    state_.comparison = is_conditional ? std::nullopt : before;
    if (!state_.comparison && !is_conditional)
      state_.comparison = Comparison{state_.registers[*destination], Value::of(0), true};
    return true;
  }

  /// A pointer that is somewhere in an array is a number of its own, so that its difference to
  /// what is made of it stays known.
  void keep_apart(std::size_t r, const Value& value) {
    if (const auto limit = limit_of_sum(value.base)) state_.limits[value.base] = *limit;
    if (!is_wide(value) && (value.base != 0 || value.is_exact())) return;
    state_.limits[made(r).base] = value;
    state_.registers[r] = made(r);
  }

  /// What a sum of several numbers is between, if all but one are between numbers.
  [[nodiscard]] std::optional<Value> limit_of_sum(Base base) const {
    const std::span<const Base> parts = sums_.parts(base);
    if (parts.empty()) return std::nullopt;
    std::optional<Value> total = Value{};
    for (const Base part : parts) {
      total = sum(*total, state_.resolve({part, 0, 0}), 1);
      if (!total) return std::nullopt;
    }
    return total;
  }

  /// The operands that the flags compare: subs its two operands, others the result with 0.
  [[nodiscard]] std::optional<Comparison> comparison_of(const std::optional<Value>& value) const {
    if (instruction_.operation == Operation::sub) {
      const auto [left, right] = two_operands();
      if (left && right) return Comparison{*left, *right, false};
    }
    if (!value) return std::nullopt;
    return Comparison{*value, Value::of(0), true};
  }

  const Image& image_;
  const Instruction& instruction_;
  State& state_;
  const Sums& sums_;
};

}  // namespace

void apply(const Image& image, const Instruction& instruction, State& state, Sums& sums) {
  Step(image, instruction, state, sums).apply();
}

}  // namespace eagerx::gen::bound

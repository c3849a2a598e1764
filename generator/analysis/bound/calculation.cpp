#include "generator/analysis/bound/calculation.hpp"

#include <bit>

#include "generator/analysis/bound/operands.hpp"

namespace eagerx::gen::bound {

std::string_view Calculation::operand(std::size_t i) const {
  return i < instruction_.operands.size() ? std::string_view(instruction_.operands[i])
                                          : std::string_view();
}

std::optional<std::size_t> Calculation::register_at(std::size_t i) const {
  if (i >= instruction_.values.size()) return std::nullopt;
  const std::uint8_t found = instruction_.values[i].reg;
  return found == Operand::kNoRegister ? std::nullopt : std::optional<std::size_t>(found);
}

std::optional<std::int64_t> Calculation::number_at(std::size_t i) const {
  return i < instruction_.values.size() ? instruction_.values[i].number : std::nullopt;
}

std::optional<Value> Calculation::read(std::size_t i) const {
  if (const auto number = number_at(i)) return Value::of(as_signed(*number));
  const auto r = register_at(i);
  return r && *r != kCore - 1 ? std::optional(state_.registers[*r]) : std::nullopt;
}

std::pair<std::optional<Value>, std::optional<Value>> Calculation::two_operands() const {
  const bool three = instruction_.operands.size() >= 3;
  return {read(three ? 1 : 0), shifted(three ? 2 : 1)};
}

/// "r3" or "r3, lsl #2".
std::optional<Value> Calculation::shifted(std::size_t i) const {
  auto value = read(i);
  if (instruction_.operands.size() <= i + 1 || !value) return value;
  if (!operand(i + 1).starts_with("lsl ")) return std::nullopt;
  return scaled(*value, number_of(operand(i + 1).substr(4)));
}

std::optional<Value> Calculation::of_bits(unsigned bits) const {
  const auto r = register_at(0);
  if (!r || bits > 31) return std::nullopt;
  const Location where{false, static_cast<std::int64_t>(*r)};
  return Value{base_of_bits(instruction_.at, where, bits), 0, 0};
}

std::optional<Value> Calculation::scaled(const Value& unscaled,
                                         std::optional<std::int64_t> shift) const {
  const Value value = state_.resolve(unscaled);
  if (!shift || *shift < 0 || *shift > 31 || value.base != 0 || value.low < 0) return std::nullopt;
  const Value result{0, value.low << *shift, value.high << *shift};
  return result.high <= INT32_MAX ? std::optional(result) : std::nullopt;
}

/// A sum, or a difference with `sign` -1. Numbers wrap as those of the machine do.
std::optional<Value> Calculation::total(const Known& a, const Known& b, int sign) const {
  if (!a || !b) return std::nullopt;
  if (a->is_number() && b->is_number()) return Value::of(as_signed(a->low + sign * b->low));
  if (sign < 0 || a->base == 0 || b->base == 0 || a->base == kStack || b->base == kStack)
    return sum(*a, *b, sign);
  const auto both = sums_.of(a->base, b->base);
  const auto offset = sum(Value{0, a->low, a->high}, Value{0, b->low, b->high}, 1);
  if (!both || !offset) return std::nullopt;
  return Value{*both, offset->low, offset->high};
}

bool Calculation::result(Known& value) const {
  const auto [left, right] = two_operands();
  const std::size_t count = instruction_.operands.size();
  switch (instruction_.operation) {
    case Operation::mov:
      if (count == 3) return shift(value);
      if (count != 2) return false;
      value = read(1);
      return true;
    case Operation::vmov:
      if (count != 2 || !register_at(1)) return false;  // a float's bits
      value = read(1);
      return true;
    case Operation::movt: {
      const auto low = read(0), high = read(1);
      if (low && high && low->is_number())
        value = Value::of(as_signed((low->low & 0xffff) | (high->low << 16)));
      return true;
    }
    case Operation::mvn:
      if (right && right->is_number() && count == 2) value = Value::of(as_signed(~right->low));
      return true;
    case Operation::add:
      value = total(left, right, 1);
      return true;
    case Operation::sub:
      value = total(left, right, -1);
      return true;
    case Operation::rsb:
      value = total(right, left, -1);
      return true;
    case Operation::neg:
      value = left && right ? total(Value::of(0), right, -1) : std::nullopt;
      return true;
    default:
      return bits(instruction_.operation, left, right, value);
  }
}

/// mov r0, r1, lsl #2
bool Calculation::shift(Known& value) const {
  const std::string_view text = operand(2);
  const auto by = text.size() > 4 ? number_of(text.substr(4)) : std::nullopt;
  if (!by) return false;
  const Operation operation = text.starts_with("lsl")   ? Operation::lsl
                              : text.starts_with("lsr") ? Operation::lsr
                                                        : Operation::unknown;
  return bits(operation, read(1), Value::of(*by), value);
}

bool Calculation::bits(Operation operation, const Known& left, const Known& right,
                       Known& value) const {
  const bool numbers = left && right && left->is_number() && right->is_number();
  switch (operation) {
    case Operation::lsl:
      if (left && right && right->is_number()) value = scaled(*left, right->low);
      return true;
    case Operation::lsr:
      value = shifted_right(left, right);
      return true;
    case Operation::bit_and:
      if (numbers)
        value = Value::of(left->low & right->low);
      else if (right && right->is_number() && right->low >= 0)
        value =
            of_bits(static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(right->low))));
      return true;
    case Operation::bic:
      if (numbers) value = Value::of(left->low & ~right->low);
      return true;
    case Operation::orr:
      if (numbers) value = Value::of(left->low | right->low);
      return true;
    case Operation::mul:
      if (numbers) value = Value::of(as_signed(left->low * right->low));
      return true;
    case Operation::ubfx:
      if (const auto width = number_at(3); width && *width < 31)
        value = of_bits(static_cast<unsigned>(*width));
      return true;
    case Operation::uxtb:
    case Operation::uxth:
      value = extended(right, operation == Operation::uxtb ? 8 : 16);
      return true;
    default:
      return false;
  }
}

std::optional<Value> Calculation::shifted_right(const Known& left, const Known& right) const {
  if (!right || !right->is_number() || right->low <= 0 || right->low >= 32) return std::nullopt;
  const auto from = left ? state_.resolve(*left) : Value{~Base{0}, 0, 0};
  if (from.base == 0 && from.low >= 0)
    return Value{0, from.low >> right->low, from.high >> right->low};
  return of_bits(static_cast<unsigned>(32 - right->low));
}

std::optional<Value> Calculation::extended(const Known& right, unsigned width) const {
  const auto from = right ? state_.resolve(*right) : Value{~Base{0}, 0, 0};
  if (from.base == 0 && from.low >= 0 && from.high < (std::int64_t{1} << width)) return right;
  return of_bits(width);
}

}  // namespace eagerx::gen::bound

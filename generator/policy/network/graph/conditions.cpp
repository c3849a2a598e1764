// Operators that compare numbers, and one that selects by the result. A condition is a number: 1 if
// it is true, else 0.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;
using Operation = Elementwise::Operation;
using Result = std::optional<NetValue>;

NetValue unknown(const NetCall& call) {
  return call.misused("that is not of the observation and of shapes that fit", call.common_shape());
}

Result as_condition(Result value) {
  if (value) value->is_condition = true;
  return value;
}

Result step(const NetCall& call, const Result& x, Operation operation, float number) {
  return x ? elementwise_step(call, *x, operation, made_constant(call, number)) : std::nullopt;
}

Result function(const NetCall& call, const Result& x, Function::Kind kind) {
  if (!x || x->kind != Kind::data) return std::nullopt;
  return call.layer_after(x->step, Function{kind}, *x->shape);
}

/// a - b: rounding never changes whether it is above, below or at zero.
Result difference(const NetCall& call, const NetValue& a, const NetValue& b) {
  if (auto value = combined(call, a, b, Combination::Operation::difference)) return value;
  if (a.kind == Kind::data) return elementwise_step(call, a, Operation::subtract, b);
  const Result negative = step(call, b, Operation::multiply, -1.0F);
  return negative ? elementwise_step(call, *negative, Operation::add, a) : std::nullopt;
}

Result above(const NetCall& call, const NetValue& a, const NetValue& b) {
  return as_condition(function(call, difference(call, a, b), Function::Kind::above_zero));
}

/// 1 - c.
Result opposite(const NetCall& call, const Result& condition) {
  const Result negative = step(call, condition, Operation::multiply, -1.0F);
  return as_condition(step(call, negative, Operation::add, 1.0F));
}

Result is_not_zero(const NetCall& call, const NetValue& x) {
  if (x.is_condition) return x;
  const Result size = function(call, x, Function::Kind::abs);
  return as_condition(function(call, size, Function::Kind::above_zero));
}

NetValue or_unknown(const NetCall& call, const Result& value) {
  return value ? *value : unknown(call);
}

NetValue greater(const NetCall& call) {
  return or_unknown(call, above(call, call.input(0), call.input(1)));
}
NetValue less(const NetCall& call) {
  return or_unknown(call, above(call, call.input(1), call.input(0)));
}
NetValue greater_or_equal(const NetCall& call) {
  return or_unknown(call, opposite(call, above(call, call.input(1), call.input(0))));
}
NetValue less_or_equal(const NetCall& call) {
  return or_unknown(call, opposite(call, above(call, call.input(0), call.input(1))));
}

/// Of sizes, too: exporters compare a shape with -1.
NetValue equal(const NetCall& call) {
  const auto same = [](const Integers& x) -> std::int64_t { return x[0] == x[1] ? 1 : 0; };
  if (call.input_count() != 2) return unknown(call);
  if (const auto sizes = each_of_integers(call, 2, same)) return *sizes;
  const Result off = difference(call, call.input(0), call.input(1));
  return or_unknown(call, off ? opposite(call, is_not_zero(call, *off)) : std::nullopt);
}

/// (x > 0) - (0 > x).
NetValue sign(const NetCall& call) {
  const NetValue& x = call.input(0);
  const NetValue zero = made_constant(call, 0.0F);
  const Result up = above(call, x, zero);
  const Result down = above(call, zero, x);
  return or_unknown(
      call, up && down ? combined(call, *up, *down, Combination::Operation::difference) : up);
}

NetValue negation(const NetCall& call) {
  return or_unknown(call, opposite(call, is_not_zero(call, call.input(0))));
}

Result both(const NetCall& call, const Result& a, const Result& b) {
  if (!a || !b) return std::nullopt;
  return as_condition(combined(call, *a, *b, Combination::Operation::product));
}
NetValue conjunction(const NetCall& call) {
  return or_unknown(call,
                    both(call, is_not_zero(call, call.input(0)), is_not_zero(call, call.input(1))));
}
NetValue disjunction(const NetCall& call) {
  const Result neither = both(call, opposite(call, is_not_zero(call, call.input(0))),
                              opposite(call, is_not_zero(call, call.input(1))));
  return or_unknown(call, opposite(call, neither));
}

/// The constant as what comes of a condition: 0 c + constant.
Result as_data(const NetCall& call, const NetValue& condition, const NetValue& value) {
  if (value.kind != Kind::constant) return value;
  NetValue base = condition;
  const std::int64_t count = element_count(value.constant.dims).value_or(0);
  if (count > 1 && element_count(*condition.shape) == 1) {
    if (count > kMaxValues || !call.spend(count)) return call.too_much();
    base = reordered(call, condition,
                     Reorder{std::vector<std::uint32_t>(static_cast<std::size_t>(count))},
                     value.constant.dims);
  }
  const Result zero = step(call, base, Operation::multiply, 0.0F);
  return zero ? elementwise_step(call, *zero, Operation::add, value) : std::nullopt;
}

/// `select` of three values that the program knows only when it runs.
Result chosen(const NetCall& call, const NetValue& condition, const NetValue& a,
              const NetValue& b) {
  const auto shape = broadcast(broadcast(condition.shape, a.shape), b.shape);
  if (!shape || condition.kind != Kind::data) return std::nullopt;
  const Result first = as_data(call, condition, a);
  const Result second = as_data(call, condition, b);
  if (!first || !second) return std::nullopt;
  for (const NetValue* value : {&condition, &*first, &*second}) {
    if (value->kind != Kind::data)
      return value->kind == Kind::other ? Result(*value) : std::nullopt;
    const auto own = element_count(*value->shape);
    if (own != element_count(*shape) && own != 1) return std::nullopt;  // an outer product, or rows
  }
  return call.data_of({condition, *first, *second}, Combination::Operation::select, *shape);
}

NetValue where(const NetCall& call) {
  const auto pick = [](const Integers& x) { return x[0] != 0 ? x[1] : x[2]; };
  if (call.input_count() != 3) return unknown(call);
  if (const auto sizes = each_of_integers(call, 3, pick)) return *sizes;
  for (std::size_t i = 1; i < 3; ++i) {
    PolicyProblem problem;
    const NetValue& value = call.input(i);
    if (value.kind != Kind::constant || read_floats(value.constant, problem)) continue;
    return call.other(problem, call.common_shape());
  }
  return or_unknown(call, chosen(call, call.input(0), call.input(1), call.input(2)));
}

}  // namespace

std::optional<NetValue> larger_of(const NetCall& call, const NetValue& a, const NetValue& b) {
  const Result condition = above(call, a, b);
  return condition ? chosen(call, *condition, a, b) : std::nullopt;
}

std::optional<NetValue> smaller_of(const NetCall& call, const NetValue& a, const NetValue& b) {
  const Result condition = above(call, b, a);
  return condition ? chosen(call, *condition, a, b) : std::nullopt;
}

std::optional<NetValue> condition_of(const NetCall& call, const NetValue& x) {
  return is_not_zero(call, x);
}

std::vector<NetOperator> condition_operators() {
  return {{"Greater", greater, time_of_each},
          {"Less", less, time_of_each},
          {"GreaterOrEqual", greater_or_equal, time_of_each},
          {"LessOrEqual", less_or_equal, time_of_each},
          {"Equal", equal, time_of_each},
          {"Sign", sign, time_of_each},
          {"Not", negation, time_of_each},
          {"And", conjunction, time_of_each},
          {"Or", disjunction, time_of_each},
          {"Where", where, time_of_each}};
}

}  // namespace eagerx::gen

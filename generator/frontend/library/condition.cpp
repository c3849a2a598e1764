// Conditions evaluated.
#include "generator/frontend/library/condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/frontend/expression/expression.hpp"
#include "generator/frontend/spec/reference.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using Op = ConditionStep::Op;
using Value = ConditionValue;
using Number = ConditionNumber;

double as_double(const Number& number) {
  if (const auto* exact = std::get_if<Rational>(&number)) return exact->to_double();
  const auto* whole = std::get_if<std::int64_t>(&number);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(number);
}

std::optional<Rational> as_rational(const Number& number) {
  if (const auto* exact = std::get_if<Rational>(&number)) return *exact;
  const auto* whole = std::get_if<std::int64_t>(&number);
  return whole != nullptr ? std::optional<Rational>(*whole) : std::nullopt;
}

Number number_of(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const auto* exact = std::get_if<Rational>(&value)) return *exact;
  const auto* real = std::get_if<double>(&value);
  return real != nullptr ? *real : std::numeric_limits<double>::quiet_NaN();
}

Value value_of(const Number& number) {
  return std::visit([](auto value) { return Value(value); }, number);
}

bool less(const Number& a, const Number& b) {
  const auto left = as_rational(a), right = as_rational(b);
  return left && right ? *left < *right : as_double(a) < as_double(b);
}

bool equal(const Number& a, const Number& b) {
  const auto left = as_rational(a), right = as_rational(b);
  return left && right ? *left == *right : as_double(a) == as_double(b);
}

bool equal(const Value& a, const Value& b) {
  if (std::holds_alternative<bool>(a) || std::holds_alternative<std::string>(a)) return a == b;
  return equal(number_of(a), number_of(b));
}

template <class T>
T calculated(Op op, const T& a, const T& b) {
  switch (op) {
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    default:
      return a / b;
  }
}

Value arithmetic(Op op, const Number& a, const Number& b) {
  const auto left = as_rational(a), right = as_rational(b);
  const Rational exact = left && right ? calculated(op, *left, *right) : Rational(0, 0);
  if (exact.overflowed()) return calculated(op, as_double(a), as_double(b));
  if (exact.is_integer()) return exact.num();
  return exact;
}

Value magnitude(const Number& number) {
  const Number zero = std::int64_t{0};
  return less(number, zero) ? arithmetic(Op::subtract, zero, number) : value_of(number);
}

bool compare(Op op, const Value& a, const Value& b) {
  switch (op) {
    case Op::less:
      return less(number_of(a), number_of(b));
    case Op::less_equal:
      return at_most(number_of(a), number_of(b));
    case Op::greater:
      return less(number_of(b), number_of(a));
    case Op::greater_equal:
      return at_most(number_of(b), number_of(a));
    case Op::equal:
      return equal(a, b);
    default:
      return !equal(a, b);
  }
}

class Stack {
 public:
  void apply(const ConditionStep& step) {
    switch (step.op) {
      case Op::constant:
      case Op::fact:
        return push(step.value);
      case Op::negate:
        return push(arithmetic(Op::subtract, std::int64_t{0}, number_of(pop())));
      case Op::absolute:
        return push(magnitude(number_of(pop())));
      case Op::logical_not:
        return push(!is_true(pop()));
      case Op::length:
        return push(static_cast<std::int64_t>(pop_list().size()));
      case Op::increasing:
        return push(increasing(pop_list()));
      case Op::least:
      case Op::most:
        return push(extreme(step));
      case Op::one_of:
        return push(one_of(step.count));
      default:
        return binary(step.op);
    }
  }

  void push(Value value) { values_.push_back(std::move(value)); }

  Value pop() {
    if (values_.empty()) return false;
    Value value = std::move(values_.back());
    values_.pop_back();
    return value;
  }

  static bool is_true(const Value& value) {
    const bool* truth = std::get_if<bool>(&value);
    return truth != nullptr && *truth;
  }

 private:
  std::vector<Number> pop_list() {
    Value value = pop();
    if (auto* list = std::get_if<std::vector<Number>>(&value)) return std::move(*list);
    return {number_of(value)};
  }

  void binary(Op op) {
    const Value b = pop();
    const Value a = pop();
    switch (op) {
      case Op::logical_and:
        return push(is_true(a) && is_true(b));
      case Op::logical_or:
        return push(is_true(a) || is_true(b));
      case Op::add:
      case Op::subtract:
      case Op::multiply:
      case Op::divide:
        return push(arithmetic(op, number_of(a), number_of(b)));
      default:
        return push(compare(op, a, b));
    }
  }

  static bool increasing(const std::vector<Number>& list) {
    return std::adjacent_find(list.begin(), list.end(), [](const Number& a, const Number& b) {
             return !less(a, b);
           }) == list.end();
  }

  /// Of no numbers at all, the least is infinite and the most is minus infinite: what must hold for
  /// each of them holds.
  Value extreme(const ConditionStep& step) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const bool least = step.op == Op::least;
    Number result = least ? kInfinity : -kInfinity;
    for (std::size_t i = 0; i < step.count; ++i) {
      for (const Number& number : pop_list()) {
        const double value = as_double(number);
        if (std::isnan(value)) return value;
        if (least ? less(number, result) : less(result, number)) result = number;
      }
    }
    return value_of(result);
  }

  bool one_of(std::size_t count) {
    std::vector<Value> choices;
    for (std::size_t i = 0; i < count; ++i) choices.push_back(pop());
    const Value value = pop();
    return ranges::any_of(choices, [&](const Value& choice) { return equal(value, choice); });
  }

  std::vector<Value> values_;
};

bool speaks_of(const Expression& tree, const std::string& name) {
  return (tree.op == Expression::Op::reference && tree.text == name) ||
         ranges::any_of(tree.operands,
                        [&](const Expression& each) { return speaks_of(each, name); });
}

}  // namespace

bool refers_to(const YamlValue& yaml, const Reference& reference) {
  if (is_expression(yaml)) {
    ExpressionText text(yaml.text);  // its computation reports problems
    const auto tree = expression::parse(text, NameForm::dollar);
    return tree && speaks_of(*tree, to_string(reference));
  }
  return ranges::any_of(yaml.items,
                        [&](const YamlValue& item) { return refers_to(item, reference); }) ||
         ranges::any_of(yaml.entries, [&](const YamlValue::Entry& entry) {
           return refers_to(entry.value, reference);
         });
}

std::optional<Value> evaluate(const Condition& condition, const Facts& facts) {
  Stack stack;
  for (const auto& step : condition) {
    if (step.op != Op::fact) {
      stack.apply(step);
      continue;
    }
    const auto fact = facts.find(step.fact);
    if (fact == facts.end()) return std::nullopt;
    stack.push(fact->second);
  }
  return stack.pop();
}

Condition always() {
  ConditionStep step;
  step.value = true;
  return {step};
}

std::optional<bool> holds(const Condition& condition, const Facts& facts) {
  const auto value = evaluate(condition, facts);
  return value ? std::optional(Stack::is_true(*value)) : std::nullopt;
}

bool at_most(const ConditionNumber& a, const ConditionNumber& b) {
  return less(a, b) || equal(a, b);
}

std::string to_string(const ConditionValue& value) {
  struct Writer {
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(std::int64_t whole) const { return fmt::format("{}", whole); }
    std::string operator()(double real) const { return fmt::format("{}", real); }
    std::string operator()(const Rational& exact) const { return exact.to_string(); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const std::vector<Number>& list) const {
      std::vector<std::string> items;
      items.reserve(list.size());
      for (const Number& number : list) items.push_back(eagerx::gen::to_string(number));
      return fmt::format("[{}]", join(items, ", "));
    }
  };
  return std::visit(Writer{}, value);
}

}  // namespace eagerx::gen

#include "generator/backend/emit/expression_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

using Op = TypedExpression::Op;

enum Precedence : int { kOr, kAnd, kCompare, kAdd, kMultiply, kUnary, kWhole };

}  // namespace

std::string real_literal(double value) {
  return fmt::format("Real({})", value);
}

std::string ExpressionWriter::within(const Text& text, int precedence) {
  return text.precedence < precedence ? "(" + text.text + ")" : text.text;
}

std::string ExpressionWriter::write(const TypedExpression& expression,
                                    std::vector<std::string>& lines) {
  lines_ = &lines;
  return of(expression).text;
}

std::string ExpressionWriter::write_weighted(const TypedExpression& expression, double weight,
                                             std::vector<std::string>& lines) {
  lines_ = &lines;
  const Text value = of(expression);
  if (weight == 1.0) return value.text;
  if (weight == -1.0) return "-" + within(value, kUnary);
  // The product is of the weight and the value, whatever the value is a product of.
  return real_literal(weight) + " * " + within(value, kUnary);
}

std::string ExpressionWriter::argument(const TypedExpression& part) {
  return of(part).text;
}

ExpressionWriter::Text ExpressionWriter::of(const TypedExpression& part) {
  switch (part.op) {
    case Op::number:
      return {real_literal(part.value), kWhole};
    case Op::truth:
      return {part.truth ? "true" : "false", kWhole};
    case Op::time:
      return {time_, kWhole};
    case Op::variable:
    case Op::before:
      return variable(part);
    case Op::element: {
      const std::string outer = std::exchange(index_, fmt::format("{}", part.count));
      Text text = of(part.operands[0]);
      index_ = outer;
      return text;
    }
    case Op::function:
      return function(part.function, part);
    case Op::power:
      return function(part.count == 2 ? "square" : "cube", part);
    case Op::negate:
      return {"-" + within(of(part.operands[0]), kWhole), kUnary};
    case Op::logical_not:
      return {"!" + within(of(part.operands[0]), kWhole), kUnary};
    case Op::choose:
      return function("select", part);
    case Op::add:
      return operation(part, "+", kAdd);
    case Op::subtract:
      return operation(part, "-", kAdd);
    case Op::multiply:
      return operation(part, "*", kMultiply);
    case Op::divide:
      return operation(part, "/", kMultiply);
    case Op::less:
      return operation(part, "<", kCompare);
    case Op::less_equal:
      return operation(part, "<=", kCompare);
    case Op::greater:
      return operation(part, ">", kCompare);
    case Op::greater_equal:
      return operation(part, ">=", kCompare);
    case Op::equal:
      return operation(part, "==", kCompare);
    case Op::not_equal:
      return operation(part, "!=", kCompare);
    case Op::logical_and:
      return operation(part, "&&", kAnd);
    case Op::logical_or:
      return operation(part, "||", kOr);
    default:
      return reduction(part);
  }
}

/// Both sides are computed in the order that is written: a - (b + c) keeps its parentheses. They
/// also stand around `and` within `or`, as compilers advise.
ExpressionWriter::Text ExpressionWriter::operation(const TypedExpression& part, const char* sign,
                                                   int precedence) {
  const int left = precedence == kOr ? kCompare : precedence;
  Text first = of(part.operands[0]);
  if (part.operands[0].op == Op::logical_or && precedence == kOr) first.precedence = kWhole;
  const Text second = of(part.operands[1]);
  return {fmt::format("{} {} {}", within(first, left), sign, within(second, precedence + 1)),
          precedence};
}

ExpressionWriter::Text ExpressionWriter::function(const std::string& name,
                                                  const TypedExpression& part) {
  std::vector<std::string> arguments;
  for (const TypedExpression& operand : part.operands) arguments.push_back(argument(operand));
  return {fmt::format("eagerx::{}({})", name, join(arguments, ", ")), kWhole};
}

ExpressionWriter::Text ExpressionWriter::variable(const TypedExpression& part) {
  const VariableText& variable = variables_[part.variable];
  const std::string& name = part.op == Op::before ? variable.before : variable.name;
  if (!part.is_list()) return {name, kWhole};
  const std::string element = fmt::format("{}[{}]", name, index_);
  const bool casts = variable.casts && !part.is_condition;
  return {casts ? fmt::format("static_cast<Real>({})", element) : element, kWhole};
}

/// A local that a loop has added up, once for all that need it.
ExpressionWriter::Text ExpressionWriter::reduction(const TypedExpression& part) {
  const TypedExpression& list = part.operands[0];
  const std::string outer = std::exchange(index_, "i");
  const std::string each =
      part.op == Op::norm ? fmt::format("eagerx::square({})", of(list).text) : of(list).text;
  index_ = "0";
  const bool extreme = part.op == Op::least || part.op == Op::most;
  const std::string first = extreme ? of(list).text : "";
  index_ = outer;
  const char* kind = part.op == Op::norm    ? "squares"
                     : part.op == Op::least ? "least"
                     : part.op == Op::most  ? "most"
                                            : "sum";
  const auto [found, is_new] = known_.try_emplace(fmt::format("{} {}", kind, each));
  if (is_new) {
    found->second = locals_.unique(fmt::format("{}_{}", kind, known_.size()));
    const std::string& local = found->second;
    lines_->push_back(extreme ? fmt::format("Real {} = {};", local, first)
                              : fmt::format("Real {}{{}};", local));
    lines_->push_back(
        fmt::format("for (std::size_t i = {}; i < {}; ++i) {{", extreme ? 1 : 0, list.size()));
    lines_->push_back(extreme ? fmt::format("  {} = eagerx::{}({}, {});", local,
                                            part.op == Op::least ? "min" : "max", local, each)
                              : fmt::format("  {} += {};", local, each));
    lines_->push_back("}");
  }
  const std::string& local = found->second;
  if (part.op == Op::norm) return {fmt::format("eagerx::sqrt({})", local), kWhole};
  if (part.op != Op::mean) return {local, kWhole};
  return {fmt::format("{} / {}", local, real_literal(static_cast<double>(list.size()))), kMultiply};
}

}  // namespace eagerx::gen

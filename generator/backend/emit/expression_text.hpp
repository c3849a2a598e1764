// Expressions of a task as C++ over Real.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/backend/emit/namer.hpp"

namespace eagerx::gen {

/// How C++ calls a variable.
struct VariableText {
  std::string name, before;
  bool casts = false;  // elements of a list are of another type than Real
};

class ExpressionWriter {
 public:
  /// `locals` hands out the names of sums.
  ExpressionWriter(std::vector<VariableText> variables, std::string time, Names& locals)
      : variables_(std::move(variables)), time_(std::move(time)), locals_(locals) {}

  /// A number or a boolean: "Real(2) * abs(theta)". Appends lines that must precede it to `lines`.
  std::string write(const TypedExpression& expression, std::vector<std::string>& lines);
  /// The same with a factor in front.
  std::string write_weighted(const TypedExpression& expression, double weight,
                             std::vector<std::string>& lines);

 private:
  /// A text and how tightly it holds together.
  struct Text {
    std::string text;
    int precedence;
  };
  Text of(const TypedExpression& part);
  Text operation(const TypedExpression& part, const char* sign, int precedence);
  Text function(const std::string& name, const TypedExpression& part);
  Text reduction(const TypedExpression& part);
  Text variable(const TypedExpression& part);
  std::string argument(const TypedExpression& part);
  static std::string within(const Text& text, int precedence);

  std::vector<VariableText> variables_;
  std::string time_;
  Names& locals_;
  std::vector<std::string>* lines_ = nullptr;
  std::string index_;                         // of the element of lists that is meant
  std::map<std::string, std::string> known_;  // locals, by what they are
};

/// "Real(0.1)"
std::string real_literal(double value);

}  // namespace eagerx::gen

// Expressions on the command line: --until, --measure. The language of the conditions in manifests:
//
//   or, and, not; < <= > >= == !=, not chained; + - * / and parentheses; 12, 0.5, 1e-3
//   abs(x), min(x, …), max(x, …); time; names of ports with an element: pendulum.theta,
//   actions.u[0]
//
// Parsed before the run; evaluated on a stack of fixed size, without allocating.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::linux_sim {

class Expression {
 public:
  /// What a name and an element (0 if none is written, then `is_indexed` is false) stand for: the
  /// number of a variable. Otherwise -1, with `problem` set.
  using Lookup = std::function<int(const std::string& name, std::size_t index, bool is_indexed,
                                   std::string& problem)>;

  /// What is wrong with `text`, with its column from 1, or nothing.
  std::string parse(std::string_view text, const Lookup& lookup);

  const std::string& text() const { return text_; }
  /// Whether it is true or false; else it is a number.
  bool is_condition() const { return is_condition_; }
  /// With the variables' values, by their numbers. A condition gives 0 or 1; NaN compares false.
  double value(const double* variables) const;

  enum class Op : std::uint8_t {
    number,
    variable,
    add,
    subtract,
    multiply,
    divide,
    negate,
    absolute,
    least,
    most,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    logical_and,
    logical_or,
    logical_not
  };
  struct Step {
    Op op = Op::number;
    double number = 0.0;
    std::size_t variable = 0;
  };
  static constexpr std::size_t kDeepest = 64;  // values on the stack

 private:
  std::string text_;
  std::vector<Step> steps_;  // in postfix order
  bool is_condition_ = false;
};

}  // namespace eagerx::linux_sim

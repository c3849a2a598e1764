// Expressions about a run (tasks, --until, --measure), with the type of each part and the variables
// that it reads.
//
//   names:    variables, each a number, a list of numbers, or true or false; `time` in seconds
//             since the reset; `pi`
//   numbers:  + - * / ^ and functions go element by element; one number goes with every list
//   lists:    sum, norm, mean, and min or max of one list make one number of it
//   before:   before(x) is the variable x one step before
//   where:    where(condition, a, b) is a if it holds, else b
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <runtime/host/expression/text.hpp>
#include <string>
#include <vector>

namespace eagerx::expression {

/// The meaning of a name.
struct Variable {
  std::string name;
  bool is_condition = false;         // true or false, else a number
  std::vector<std::uint64_t> shape;  // []: one
};

/// A number, a list of them, or true or false.
struct Typed {
  enum class Op : std::uint8_t {
    number,
    truth,
    time,
    variable,
    before,  // the variable, one step before
    element,
    function,  // of eagerx/math.hpp, of one or two numbers
    power,
    negate,
    add,
    subtract,
    multiply,
    divide,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    logical_and,
    logical_or,
    logical_not,
    choose,  // the second operand if the first holds, else the third
    sum,     // of the elements of a list, in their order
    mean,
    norm,
    least,
    most
  };
  Op op = Op::number;
  bool is_condition = false;
  std::vector<std::uint64_t> shape;
  double value = 0.0;        // number
  bool truth = false;        // truth
  std::size_t variable = 0;  // variable, before
  std::uint32_t count = 0;   // element: which, row-major; power: the exponent
  std::string function;      // its name in C++
  std::vector<Typed> operands;

  [[nodiscard]] bool is_list() const { return !shape.empty(); }
  /// Of a list.
  [[nodiscard]] std::uint64_t size() const;
};

enum class Type : bool { number, condition };

/// The meaning of names, and the handler of unknown ones.
struct Names {
  const std::vector<Variable>& variables;
  NameForm form = NameForm::plain;
  std::function<std::string(const std::string& name)>
      help{};  // for an unknown name; empty: list the known names
  /// If set, returns the variable that another name means, or an empty text.
  std::function<std::string(const std::string& name)> meant{};
};

/// The whole text as an expression of the type that is wanted: one number, or one truth. nullopt
/// after a problem.
std::optional<Typed> read_typed(Text& text, const Names& names, Type wanted);

/// Whether it reads a variable or the time; else it is the same after every step.
bool varies(const Typed& expression);

/// Calls f(part) for the expression and everything in it.
template <class F>
void for_each_part(const Typed& expression, F&& f) {
  f(expression);
  for (const Typed& operand : expression.operands) for_each_part(operand, f);
}

}  // namespace eagerx::expression

// The language of everything in a graph or manifest that is calculated: what manifests require
// (`max(cutoff_hz) < rate / 2`), arithmetic with `$(config limit)`, and the task of a graph.
//
//   or:       and, not binds tighter; `a or b and not c`
//   compare:  < <= > >= == !=, `x in (a, b)`; not chained
//   number:   + - * /, then the sign, then ^2 and ^3; parentheses; 12, 0.5, 1e-3; true, false
//   names:    `name`, `group.name`; an element of a list: `name[2]`
//   calls:    function(…, …)
//
// What names and functions there are, and what fits together, is for those who read the tree.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/read/rational.hpp"

namespace eagerx::gen {

class ExpressionText;

/// Whole numbers and decimals are exact as long as they fit into 64 bits; else a double.
using ExpressionNumber = std::variant<std::int64_t, double, Rational>;

/// A tree; nothing is known of its types yet.
struct Expression {
  enum class Op : std::uint8_t {
    number,
    truth,
    name,
    reference,  // a name within `$(…)`
    call,
    index,
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
    one_of,  // the first operand is one of the others
    logical_and,
    logical_or,
    logical_not
  };
  Op op = Op::number;
  std::size_t begin = 0;    // where in the text
  std::string text;         // name, reference, call: its name; number: its digits
  ExpressionNumber value;   // number
  bool truth = false;       // truth
  std::uint32_t count = 0;  // index: the element; power: the exponent
  std::vector<Expression> operands;
};

/// dollar: names are several words within `$(…)`, `$(config limit 0)`.
enum class NameForm : bool { plain, dollar };

/// The whole text as a tree; nullopt after a problem.
std::optional<Expression> parse_expression(ExpressionText& text, NameForm names);

}  // namespace eagerx::gen

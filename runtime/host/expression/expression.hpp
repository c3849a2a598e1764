// The language of all expressions in text: requirements in manifests (`max(cutoff_hz) < rate / 2`),
// arithmetic with `$(config limit)`, the task of a graph, `--until` and `--measure`. README.md is
// its description.
//
//   or:       and, not binds tighter; `a or b and not c`
//   compare:  < <= > >= == !=, `x in (a, b)`; not chained
//   number:   + - * /, then the sign, then ^2 and ^3; parentheses; 12, 0.5, 1e-3; true, false
//   names:    see NameForm; an element of a list: `name[2]`
//   calls:    function(…, …)
//
// The reader of the tree defines names, functions and types.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::expression {

class Text;

/// An untyped tree.
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
  bool truth = false;       // truth
  std::uint32_t count = 0;  // index: the element; power: the exponent
  std::vector<Expression> operands;
};

/// plain: `name`, `group.name`. dollar: also several words within `$(…)`, `$(config limit 0)`.
/// port: `node.port` and `engine/node.port`, with any number of parts.
enum class NameForm : std::uint8_t { plain, dollar, port };

/// The whole text as a tree; nullopt after a problem. `has_where`: the reader of the tree supports
/// `where(condition, a, b)`, which messages suggest for the conditional expressions of other
/// languages.
std::optional<Expression> parse(Text& text, NameForm names, bool has_where = false);

/// Digits with an optional point and exponent, as the grammar takes them; nullopt beyond a double.
std::optional<double> parse_digits(std::string_view digits);

}  // namespace eagerx::expression

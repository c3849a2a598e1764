// Conditions that manifests state about parameters, ports and rates: `max(cutoff_hz) < rate / 2`.
//
//   or:       and, not binds tighter; `a or b and not c`
//   compare:  < <= > >= == !=, `x in (a, b)`; not chained
//   number:   + - * / and parentheses; 12, 0.5, 1e-3; true, false
//   names:    parameters; `rate` of the node in Hz; the choices of an enum: `type == bandpass`
//   calls:    min(…), max(…) of numbers and lists; len(LIST); increasing(LIST);
//             size(PORT), window(INPUT), dtype(PORT)
//
// A port is written by its name, or as inputs.NAME, outputs.NAME, states.NAME where the name alone
// could mean two. Whole numbers are exact in 64 bits as long as a result fits, all others are
// doubles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

struct Entity;
struct YamlValue;

using ConditionNumber = std::variant<std::int64_t, double>;
using ConditionValue =
    std::variant<bool, std::int64_t, double, std::string, std::vector<ConditionNumber>>;

/// What a condition speaks of, by the names of ConditionStep::fact.
using Facts = std::map<std::string, ConditionValue>;

/// One step on a stack: conditions are kept in postfix order, so that nothing recurses when they
/// are evaluated.
struct ConditionStep {
  enum class Op : std::uint8_t {
    constant,
    fact,
    add,
    subtract,
    multiply,
    divide,
    negate,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    one_of,
    logical_and,
    logical_or,
    logical_not,
    length,
    least,
    most,
    increasing
  };
  Op op = Op::constant;
  ConditionValue value;   // constant
  std::string fact;       // "order", "rate", "size(inputs.signal)"
  std::string written;    // the fact as the manifest writes it: "size(signal)"
  std::size_t count = 0;  // least, most, one_of: arguments
};

using Condition = std::vector<ConditionStep>;

/// A condition from its text; `entity` has its parameters and ports already. Problems, at their
/// place in the text: E0207. nullopt then.
std::optional<Condition> read_condition(const YamlValue& text, const Entity& entity,
                                        Diagnostics& diagnostics);

/// Whether the condition holds; nullopt if it speaks of something that is not among the facts.
std::optional<bool> holds(const Condition& condition, const Facts& facts);

/// a <= b; whole numbers are compared exactly. False if one is NaN.
bool at_most(const ConditionNumber& a, const ConditionNumber& b);

/// A value as messages show it: "20", "[10, 20]", "bandpass".
std::string to_string(const ConditionValue& value);
std::string to_string(const ConditionNumber& number);

}  // namespace eagerx::gen

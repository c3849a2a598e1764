// Conditions that manifests state about parameters, ports and rates: `max(cutoff_hz) < rate / 2`.
// In the same language they compute numbers from what the graph says: `2 * $(config limit)`.
//
//   the language:  runtime/host/expression/README.md
//   names:         parameters; `rate` of the node in Hz; the choices of an enum: `type == bandpass`
//   calls:         abs(…); min(…), max(…) of numbers and lists; len(LIST); increasing(LIST);
//                  size(PORT), window(INPUT), dtype(PORT)
//
// A port is written by its name, or as inputs.NAME, outputs.NAME, states.NAME where the name alone
// could mean two. Decimals are exact fractions as long as a result fits into 64 bits, all other
// numbers are doubles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/frontend/expression/expression.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

struct Entity;
struct Reference;
struct YamlValue;

using ConditionNumber = ExpressionNumber;
using ConditionValue =
    std::variant<bool, std::int64_t, double, Rational, std::string, std::vector<ConditionNumber>>;

/// The facts of a condition, by the names of ConditionStep::fact.
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
    absolute,
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

/// The target of a `$(…)`: `config limit`, `config limit 0`, `sensors theta rate`. References whose
/// value is not known have none.
using KnownReferences = std::map<std::string, std::optional<ConditionValue>, std::less<>>;

/// Whether one of the expressions in `yaml` speaks of it: `$(2 * rate)`.
bool refers_to(const YamlValue& yaml, const Reference& reference);

/// A number computed from references; a list or text where it is nothing but a reference to one.
/// Problems, at their place: E0324. nullopt then.
std::optional<Condition> read_expression(const YamlValue& text, const KnownReferences& references,
                                         Diagnostics& diagnostics);

/// The value of a condition or expression; nullopt if it speaks of something that is not among the
/// facts.
std::optional<ConditionValue> evaluate(const Condition& condition, const Facts& facts);

/// A condition that always holds.
Condition always();

/// Whether the condition holds; nullopt if it speaks of something that is not among the facts.
std::optional<bool> holds(const Condition& condition, const Facts& facts);

/// a <= b; whole numbers are compared exactly. False if one is NaN.
bool at_most(const ConditionNumber& a, const ConditionNumber& b);

/// A value as messages show it: "20", "[10, 20]", "bandpass".
std::string to_string(const ConditionValue& value);

}  // namespace eagerx::gen

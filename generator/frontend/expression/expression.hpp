// Expressions of graphs and manifests: those of runtime/host/expression, with exact numbers and
// with problems at their place in the file.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <runtime/host/expression/typed.hpp>
#include <vector>

#include "generator/frontend/read/number.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

using expression::Expression;
using expression::NameForm;
using ExpressionText = expression::Text;
using TypedExpression = expression::Typed;
using ExpressionType = expression::Type;
using ExpressionVariable = expression::Variable;

using ExpressionNumber = ComputedNumber;

/// Of an Op::number.
ExpressionNumber exact_number(const Expression& number);

/// Reports the problem of `text`, the text of `yaml`, at its place. False if there is none.
bool report_problem(const ExpressionText& text, const YamlValue& yaml, const char* code,
                    Diagnostics& diagnostics);

/// An expression of a task with the required type; `help` returns a hint for an unknown variable,
/// or an empty text. nullopt after a problem, which is reported at its place in the text: E0339.
std::optional<TypedExpression> read_typed_expression(
    const YamlValue& text, const std::vector<ExpressionVariable>& variables, ExpressionType wanted,
    const std::function<std::string(const std::string&)>& help, Diagnostics& diagnostics);

}  // namespace eagerx::gen

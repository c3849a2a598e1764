#include "generator/frontend/expression/expression.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

/// Without escapes, on one line.
bool is_as_written(const YamlValue& yaml) {
  return yaml.span.length == yaml.text.size() + (yaml.quoted ? 2 : 0);
}

/// From `place` to the end of the text; all of it where it was written with escapes or over several
/// lines.
Span span_at(const YamlValue& yaml, std::size_t place) {
  const std::size_t quotes = yaml.quoted ? 2 : 0;
  if (!is_as_written(yaml)) return yaml.span;
  Span span = yaml.span;
  span.column += static_cast<std::uint32_t>(place + quotes / 2);
  span.length = static_cast<std::uint32_t>(std::max<std::size_t>(yaml.text.size() - place, 1));
  return span;
}

Span span_of(const YamlValue& yaml, std::size_t place, const std::string& word) {
  Span span = span_at(yaml, place);
  span.length = static_cast<std::uint32_t>(word.size());
  return span;
}

}  // namespace

ExpressionNumber exact_number(const Expression& number) {
  if (const auto whole = parse_int(number.text)) return *whole;
  if (const auto exact = Rational::parse(number.text)) return *exact;
  return parse_number(number.text).value_or(0.0);
}

bool report_problem(const ExpressionText& text, const YamlValue& yaml, const char* code,
                    Diagnostics& diagnostics) {
  if (text.good()) return false;
  const auto& [place, message, help, mistyped] = *text.problem();
  auto& problem = diagnostics.error(code, span_at(yaml, place), message);
  problem.help = help;
  if (!mistyped.meant.empty() && is_as_written(yaml))
    problem.help.fixes = {change_word_to(mistyped.meant, span_of(yaml, place, mistyped.name))};
  return true;
}

std::optional<TypedExpression> read_typed_expression(
    const YamlValue& yaml, const std::vector<ExpressionVariable>& variables, ExpressionType wanted,
    const std::function<std::string(const std::string&)>& help, Diagnostics& diagnostics) {
  ExpressionText text(yaml.text);
  const expression::Names names{variables, NameForm::plain, help};
  auto typed = expression::read_typed(text, names, wanted);
  return report_problem(text, yaml, "E0339", diagnostics) ? std::nullopt : std::move(typed);
}

}  // namespace eagerx::gen

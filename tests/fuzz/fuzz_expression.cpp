// Any text as an expression: no crash, a problem within the text, and what can be calculated is.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <runtime/host/expression/calculation.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace eagerx::expression;

void require(bool holds) {
  if (!holds) std::abort();
}

void calculate(std::string_view text, Type type) {
  static const std::vector<Variable> kVariables = {
      {"a.x", false, {1}}, {"b", false, {3}}, {"c/d.e", false, {2, 2}}, {"on", true, {}}};
  Text piece(text);
  const auto typed = read_typed(piece, {kVariables, NameForm::port, {}}, type);
  require(typed.has_value() == piece.good());
  if (!typed) return require(piece.problem()->place <= text.size());
  std::vector<double> values;
  Calculation calculation;
  const std::string problem =
      calculation.prepare(*typed, [&](const Read& read) -> std::optional<std::size_t> {
        if (values.size() == 16) return std::nullopt;
        values.push_back(static_cast<double>(read.element) - 0.5);
        return values.size() - 1;
      });
  if (!problem.empty()) return;
  const double value = calculation.value(values.data());
  if (type == Type::condition) require(value == 0.0 || value == 1.0);
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  calculate(text, Type::number);
  calculate(text, Type::condition);
  for (const NameForm form : {NameForm::plain, NameForm::dollar}) {
    Text piece(text);
    const auto tree = parse(piece, form);
    require(tree.has_value() == piece.good());
  }
  return 0;
}

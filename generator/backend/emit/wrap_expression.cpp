#include "generator/backend/emit/wrap_expression.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "generator/backend/emit/scanner.hpp"

namespace eagerx::gen {
namespace {

/// A part of an expression, and what is behind it: an operator with a blank before it, or a comma.
struct Piece {
  std::string_view text, behind;
};

/// Operators of one precedence, the weakest first.
using Operators = std::array<std::string_view, 6>;
constexpr std::array<Operators, 5> kPrecedences = {
    {{" ||"}, {" &&"}, {" <", " >", " <=", " >=", " ==", " !="}, {" +", " -"}, {" *", " /"}}};

/// Operands of these operators, which have a blank behind them, outside of brackets.
std::vector<Piece> divided(std::string_view text, const auto& separators) {
  std::vector<Piece> parts;
  std::size_t begin = 0;
  for (Scanner scan(text); scan.next();) {
    if (scan.in_literal() || scan.depth() != 0 || scan.at() < begin) continue;
    const std::string_view rest = text.substr(scan.at());
    for (const std::string_view separator : separators) {
      if (separator.empty() || !rest.starts_with(separator) ||
          !rest.substr(separator.size()).starts_with(' '))
        continue;
      parts.push_back({text.substr(begin, scan.at() - begin), separator});
      begin = scan.at() + separator.size() + 1;
      break;
    }
  }
  parts.push_back({text.substr(begin), {}});
  return parts;
}

/// The operands of the operators that are applied last; one part if there is none.
std::vector<Piece> operands_of(std::string_view text) {
  for (const Operators& operators : kPrecedences) {
    auto parts = divided(text, operators);
    if (parts.size() > 1) return parts;
  }
  return {{text, {}}};
}

/// `f(a, b)`, where the call is all of the text; without parts if it is none.
struct CallText {
  std::string_view head;  // with its bracket
  std::vector<Piece> arguments;
};
CallText call_of(std::string_view text) {
  const std::size_t open = text.find('(');
  if (open == kNone || !text.ends_with(')')) return {};
  const std::string_view inside = text.substr(open + 1, text.size() - open - 2);
  return {text.substr(0, open + 1), divided(inside, std::array<std::string_view, 1>{","})};
}

/// Columns behind a part that have to be in its line.
std::size_t behind(const Piece& part, std::size_t tail) {
  return part.behind.empty() ? tail : part.behind.size();
}

class ExpressionLines {
 public:
  explicit ExpressionLines(std::string begin)
      : text_(std::move(begin)), column_(columns_of(text_)) {}

  /// Whether it fits in lines from `column` on, each with a whole operand.
  static bool fits(std::string_view text, std::size_t column, std::size_t tail) {
    const auto operands_fit = [](std::string_view sum, std::size_t at, std::size_t last) {
      return std::ranges::all_of(operands_of(sum), [&](const Piece& part) {
        return at + columns_of(part.text) + behind(part, last) <= kColumns;
      });
    };
    const CallText call = operands_of(text).size() > 1 ? CallText() : call_of(text);
    const std::size_t inside = column + columns_of(call.head);
    return operands_fit(text, column, tail) ||
           (!call.arguments.empty() && std::ranges::all_of(call.arguments, [&](const Piece& part) {
             return operands_fit(part.text, inside, behind(part, tail + 1));
           }));
  }

  /// `indent`: what is below it in the same statement is deeper than that.
  void write(std::string_view text, std::size_t indent, std::size_t tail) {
    const auto operands = operands_of(text);
    const CallText call = operands.size() > 1 ? CallText() : call_of(text);
    if (column_ + columns_of(text) + tail <= kColumns ||
        (operands.size() == 1 && call.arguments.empty()))
      return append(text);
    if (operands.size() > 1) return write_parts(operands, column_, tail);
    const bool below =
        !fits(text, column_, tail) && column_ + columns_of(call.head) > indent + kDeeper;
    append(call.head);
    if (below) next_line(indent + kDeeper);
    write_parts(call.arguments, column_, tail + 1);
    append(")");
  }

  void next_line(std::size_t column) {
    text_ += '\n' + std::string(column, ' ');
    column_ = column;
  }
  void append(std::string_view text) {
    text_ += text;
    column_ += columns_of(text);
  }
  [[nodiscard]] std::size_t column() const { return column_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static constexpr std::size_t kDeeper = 4;

  void write_parts(const std::vector<Piece>& parts, std::size_t begin, std::size_t tail) {
    for (const Piece& part : parts) {
      const std::size_t rest = behind(part, tail);
      if (&part != &parts.front()) {
        const bool same_line = column_ + 1 + columns_of(part.text) + rest <= kColumns;
        same_line ? append(" ") : next_line(begin);
      }
      write(part.text, begin, rest);
      append(part.behind);
    }
  }

  std::string text_;
  std::size_t column_ = 0;
};

}  // namespace

std::string wrapped_assignment(std::string_view line, std::size_t indent) {
  constexpr std::size_t kDeeper = 4;
  const auto sides =
      divided(line.substr(0, line.size() - 1), std::array<std::string_view, 1>{" ="});
  if (!line.ends_with(';') || sides.size() != 2 || line.find('{') != kNone ||
      line.find('"') != kNone)
    return {};
  const std::string_view value = sides[1].text;
  ExpressionLines lines(std::string(sides[0].text) + " =");
  const bool aside = ExpressionLines::fits(value, lines.column() + 1, 1);
  if (!aside && operands_of(value).size() > 1)
    lines.next_line(indent + kDeeper);
  else
    lines.append(" ");
  lines.write(value, indent, 1);
  return lines.text() + ';';
}

}  // namespace eagerx::gen

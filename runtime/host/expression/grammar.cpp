// Expressions from their text: recursive descent, loosest operators first.
#include <charconv>
#include <runtime/host/base/number.hpp>
#include <runtime/host/expression/text.hpp>
#include <utility>

namespace eagerx::expression {
namespace {

using Tree = Expression::Op;

class Grammar {
 public:
  Grammar(Text& text, NameForm names, bool has_where)
      : text_(text), names_(names), has_where_(has_where) {}

  std::optional<Expression> read() {
    Expression all = disjunction();
    if (!text_.at_end())
      text_.fail(text_.place(), "expected the end, found " + text_.next(), foreign_operator());
    return text_.good() ? std::optional(std::move(all)) : std::nullopt;
  }

 private:
  /// The spelling of the next token if it is an operator of another language; empty without one.
  std::string foreign_operator() {
    if (text_.peek('*')) return "write a power as `x^2`";
    if (text_.peek('&')) return "write `and`: `x > 0 and y > 0`";
    if (text_.peek('|')) return "write `or`: `x > 0 or y > 0`";
    if (text_.peek('!')) return "write `not`: `not x > 0`";
    const bool chooses = text_.peek('?') || text_.next() == "`if`";
    if (chooses && has_where_) return "write `where(x > 0, a, b)`";
    return {};
  }

  static Expression of(Tree op, std::size_t begin, std::vector<Expression> operands) {
    Expression result;
    result.op = op;
    result.begin = begin;
    result.operands = std::move(operands);
    return result;
  }
  static Expression joined(Tree op, Expression left, Expression right) {
    const std::size_t begin = left.begin;
    std::vector<Expression> operands;
    operands.push_back(std::move(left));
    operands.push_back(std::move(right));
    return of(op, begin, std::move(operands));
  }

  Expression disjunction() {
    const Text::Nested nested(text_);
    Expression left = conjunction();
    while (text_.take_word("or")) left = joined(Tree::logical_or, std::move(left), conjunction());
    return left;
  }

  Expression conjunction() {
    Expression left = negation();
    while (text_.take_word("and")) left = joined(Tree::logical_and, std::move(left), negation());
    return left;
  }

  Expression negation() {
    const Text::Nested nested(text_);
    const std::size_t begin = text_.place();
    if (!text_.take_word("not")) return comparison();
    return of(Tree::logical_not, begin, {negation()});
  }

  Expression comparison() {
    Expression left = sum();
    if (text_.take_word("in")) return membership(std::move(left));
    const auto op = text_.take_comparison();
    if (!op) return left;
    Expression result = joined(*op, std::move(left), sum());
    const std::size_t after = text_.place();
    if (text_.take_comparison())
      text_.fail(after, "comparisons cannot be chained", "join them: `0 < x and x < 1`");
    return result;
  }

  Expression membership(Expression left) {
    const std::size_t begin = left.begin;
    std::vector<Expression> operands;
    operands.push_back(std::move(left));
    text_.require('(');
    do {
      operands.push_back(sum());
    } while (text_.take(','));
    text_.require(')');
    return of(Tree::one_of, begin, std::move(operands));
  }

  Expression sum() {
    Expression left = product();
    while (text_.good()) {
      if (text_.take('+')) {
        left = joined(Tree::add, std::move(left), product());
      } else if (text_.take('-')) {
        left = joined(Tree::subtract, std::move(left), product());
      } else {
        break;
      }
    }
    return left;
  }

  Expression product() {
    Expression left = sign();
    while (text_.good()) {
      if (text_.take('*')) {
        left = joined(Tree::multiply, std::move(left), sign());
      } else if (text_.take('/')) {
        left = joined(Tree::divide, std::move(left), sign());
      } else {
        break;
      }
    }
    return left;
  }

  Expression sign() {
    const Text::Nested nested(text_);
    const std::size_t begin = text_.place();
    if (!text_.take('-')) return power();
    return of(Tree::negate, begin, {sign()});
  }

  Expression power() {
    Expression base = element();
    if (!text_.take('^')) return base;
    const std::size_t place = text_.place();
    const std::string digits = text_.take_number();
    if (digits != "2" && digits != "3")
      text_.fail(place, "an exponent is 2 or 3", "write others as `pow(x, y)`");
    Expression result = of(Tree::power, base.begin, {});
    result.count = digits == "3" ? 3 : 2;
    result.operands.push_back(std::move(base));
    const std::size_t after = text_.place();
    if (text_.take('^'))
      text_.fail(after, "powers cannot be chained", "write `(x^2)^3`, or `pow(x, 6)`");
    return result;
  }

  Expression element() {
    Expression list = operand();
    while (text_.take('[')) {
      const std::size_t place = text_.place();
      const std::string digits = text_.take_number();
      std::uint32_t index = 0;
      if ((digits.size() > 1 && digits[0] == '0') ||
          !host::read_number(digits, 0U, kLargestIndex, index))
        text_.fail(place, "expected the number of an element, from 0");
      text_.require(']');
      Expression result = of(Tree::index, list.begin, {});
      result.count = index;
      result.operands.push_back(std::move(list));
      list = std::move(result);
    }
    return list;
  }

  Expression operand() {
    const std::size_t begin = text_.place();
    if (text_.take('(')) {
      Expression inside = disjunction();
      text_.require(')');
      return inside;
    }
    if (names_ == NameForm::dollar && text_.take('$')) return dollar();
    if (std::string digits = text_.take_number(); !digits.empty())
      return number(std::move(digits), begin);
    std::string word = names_ == NameForm::port ? text_.take_port_name() : text_.take_dotted_name();
    if (word.empty()) {
      text_.fail(begin, "expected a value, found " + text_.next(), foreign_operator());
      return {};
    }
    if (text_.peek('(')) return call(std::move(word), begin);
    Expression result = of(Tree::name, begin, {});
    if (word == "true" || word == "false") {
      result.op = Tree::truth;
      result.truth = word == "true";
      return result;
    }
    if (names_ == NameForm::dollar) {
      word = with_further_words(std::move(word));
      if (depth_ > 0) result.op = Tree::reference;
    }
    result.text = std::move(word);
    return result;
  }

  /// `$(…)` anywhere in the text, and what is in it.
  Expression dollar() {
    text_.require('(');
    ++depth_;
    Expression inside = sum();
    --depth_;
    text_.require(')');
    return inside;
  }

  /// `config limit`, `sensors theta rate`, `config list 0`: names with blanks between them.
  std::string with_further_words(std::string words) {
    for (std::string more = text_.take_name(); !more.empty(); more = text_.take_name())
      words += " " + more;
    if (const std::string index = text_.take_number(); !index.empty()) words += " " + index;
    return words;
  }

  Expression number(std::string digits, std::size_t begin) {
    Expression result = of(Tree::number, begin, {});
    if (!parse_digits(digits)) text_.fail(begin, "`" + digits + "` is not a number");
    result.text = std::move(digits);
    return result;
  }

  Expression call(std::string function, std::size_t begin) {
    Expression result = of(Tree::call, begin, {});
    result.text = std::move(function);
    text_.require('(');
    do {
      result.operands.push_back(disjunction());
    } while (text_.take(','));
    text_.require(')');
    return result;
  }

  static constexpr std::uint32_t kLargestIndex = 1'000'000'000;

  Text& text_;
  NameForm names_;
  bool has_where_;
  int depth_ = 0;  // of `$(`
};

}  // namespace

std::optional<double> parse_digits(std::string_view digits) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const char *const begin = digits.data(), *const end = begin + digits.size();
  // from_chars also takes "007", "inf" and "nan".
  const bool leading_zero = digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]);
  if (leading_zero || digits.empty() || !(is_digit(digits[0]) || digits[0] == '.')) return {};
  double value = 0.0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

std::optional<Expression> parse(Text& text, NameForm names, bool has_where) {
  return Grammar(text, names, has_where).read();
}

}  // namespace eagerx::expression

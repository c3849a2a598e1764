#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <targets/linux-sim/expression.hpp>
#include <utility>

namespace eagerx::linux_sim {
namespace {

using Op = Expression::Op;
using Step = Expression::Step;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Recursive descent; `true` of a rule stands for a condition, `false` for a number.
class Parser {
 public:
  Parser(std::string_view text, const Expression::Lookup& lookup) : text_(text), lookup_(lookup) {}

  bool read() {
    const bool condition = disjunction();
    skip_blanks();
    if (at_ < text_.size()) fail("expected the end");
    return condition;
  }
  std::vector<Step>& steps() { return steps_; }
  const std::string& problem() const { return problem_; }

 private:
  bool disjunction() {
    if (++depth_ > kDeepestNesting) return fail("too deep");
    const std::size_t begin = start();
    bool left = conjunction();
    while (take_word("or")) left = logical(Op::logical_or, begin, left, conjunction());
    --depth_;
    return left;
  }
  bool conjunction() {
    const std::size_t begin = start();
    bool left = negation();
    while (take_word("and")) left = logical(Op::logical_and, begin, left, negation());
    return left;
  }
  bool negation() {
    bool negated = false;
    const std::size_t begin = start();
    int count = 0;
    while (take_word("not")) {
      negated = !negated;
      ++count;
    }
    const bool operand = comparison();
    if (count == 0) return operand;
    if (!operand) fail_at(begin, "`not` is for conditions");
    if (negated) add({Op::logical_not}, 0);
    return true;
  }
  bool comparison() {
    const std::size_t begin = start();
    const bool left = sum();
    const auto op = take_comparison();
    if (!op) return left;
    const bool right = sum();
    if (left || right) fail_at(begin, "numbers are compared, not conditions");
    add({*op}, -1);
    if (take_comparison()) fail("comparisons cannot be chained: join them with `and`");
    return true;
  }
  bool sum() {
    const std::size_t begin = start();
    bool left = product();
    for (;;) {
      const std::optional<Op> op = take('+')   ? std::optional(Op::add)
                                   : take('-') ? std::optional(Op::subtract)
                                               : std::nullopt;
      if (!op || !problem_.empty()) return left;
      left = arithmetic(*op, begin, left, product());
    }
  }
  bool product() {
    const std::size_t begin = start();
    bool left = sign();
    for (;;) {
      const std::optional<Op> op = take('*')   ? std::optional(Op::multiply)
                                   : take('/') ? std::optional(Op::divide)
                                               : std::nullopt;
      if (!op || !problem_.empty()) return left;
      left = arithmetic(*op, begin, left, sign());
    }
  }
  bool sign() {
    const std::size_t begin = start();
    bool negated = false;
    int count = 0;
    while (take('-')) {
      negated = !negated;
      ++count;
    }
    const bool operand = primary();
    if (count == 0) return operand;
    if (operand) fail_at(begin, "`-` is for numbers");
    if (negated) add({Op::negate}, 0);
    return false;
  }
  bool primary() {
    skip_blanks();
    if (!problem_.empty()) return false;
    if (take('(')) {
      const bool inner = disjunction();
      require(')');
      return inner;
    }
    if (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) return number();
    if (at_ < text_.size() && is_letter(text_[at_])) return name();
    return fail("expected a number or a name");
  }
  bool number() {
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) return fail("no number");
    at_ = static_cast<std::size_t>(end - text_.data());
    add({Op::number, value}, 1);
    return false;
  }
  bool name() {
    const std::size_t begin = at_;
    bool dot = false;
    const auto goes_on = [&](char c) {
      if (c != '/') return is_letter(c) || is_digit(c) || c == '.';
      // In the names of engine nodes, `pendulum/x.observation`; elsewhere it divides.
      const bool letter = at_ + 1 < text_.size() && is_letter(text_[at_ + 1]);
      return letter && !dot && text_.substr(begin, at_ - begin) != "time";
    };
    for (; at_ < text_.size() && goes_on(text_[at_]); ++at_) dot = dot || text_[at_] == '.';
    const std::string word(text_.substr(begin, at_ - begin));
    if (word == "true" || word == "false") {
      add({Op::number, word == "true" ? 1.0 : 0.0}, 1);
      return true;
    }
    if (word == "abs" || word == "min" || word == "max") return call(word);
    std::size_t index = 0;
    const bool indexed = take('[');
    if (indexed) {
      skip_blanks();
      const auto [end, error] =
          std::from_chars(text_.data() + at_, text_.data() + text_.size(), index);
      if (error != std::errc()) return fail("expected the number of an element");
      at_ = static_cast<std::size_t>(end - text_.data());
      require(']');
    }
    if (!problem_.empty()) return false;
    std::string problem;
    const int variable = lookup_(word, index, indexed, problem);
    if (variable < 0) return fail_at(begin, problem);
    add({Op::variable, 0.0, static_cast<std::size_t>(variable)}, 1);
    return false;
  }
  bool call(const std::string& function) {
    require('(');
    std::size_t count = 0;
    do {
      if (disjunction()) fail("`" + function + "` is for numbers");
      if (++count > 1) add({function == "min" ? Op::least : Op::most}, -1);
    } while (problem_.empty() && take(','));
    require(')');
    if (function != "abs") return false;
    if (count != 1) return fail("`abs` takes one number");
    add({Op::absolute}, 0);
    return false;
  }

  bool logical(Op op, std::size_t begin, bool left, bool right) {
    if (!left || !right) fail_at(begin, "`and` and `or` join conditions");
    add({op}, -1);
    return true;
  }
  bool arithmetic(Op op, std::size_t begin, bool left, bool right) {
    if (left || right) fail_at(begin, "this is arithmetic with a condition");
    add({op}, -1);
    return false;
  }

  void add(Step step, int grows) {
    steps_.push_back(step);
    height_ += grows;
    if (height_ > static_cast<int>(Expression::kDeepest)) fail("too deep");
  }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  std::size_t start() {
    skip_blanks();
    return at_;
  }
  bool take(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  bool take_word(std::string_view word) {
    skip_blanks();
    const std::string_view rest = text_.substr(at_);
    if (!rest.starts_with(word)) return false;
    if (rest.size() > word.size() && (is_letter(rest[word.size()]) || is_digit(rest[word.size()])))
      return false;
    at_ += word.size();
    return true;
  }
  std::optional<Op> take_comparison() {
    constexpr std::array<std::pair<std::string_view, Op>, 6> kComparisons{{
        {"<=", Op::less_equal},
        {">=", Op::greater_equal},
        {"==", Op::equal},
        {"!=", Op::not_equal},
        {"<", Op::less},
        {">", Op::greater},
    }};
    skip_blanks();
    for (const auto& [sign, op] : kComparisons) {
      if (!text_.substr(at_).starts_with(sign)) continue;
      at_ += sign.size();
      return op;
    }
    return std::nullopt;
  }
  void require(char c) {
    if (!take(c)) fail(std::string("expected `") + c + "`");
  }
  bool fail(const std::string& what) { return fail_at(at_, what); }
  bool fail_at(std::size_t place, const std::string& what) {
    if (problem_.empty()) problem_ = "column " + std::to_string(place + 1) + ": " + what;
    at_ = text_.size();  // nothing more is read
    return false;
  }

  static constexpr int kDeepestNesting = 50;

  std::string_view text_;
  const Expression::Lookup& lookup_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int height_ = 0;
  std::vector<Step> steps_;
  std::string problem_;
};

double binary(Op op, double a, double b) {
  switch (op) {
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return a / b;
    case Op::least:
      return a < b || std::isnan(a) ? a : b;
    case Op::most:
      return a > b || std::isnan(a) ? a : b;
    case Op::less:
      return a < b ? 1.0 : 0.0;
    case Op::less_equal:
      return a <= b ? 1.0 : 0.0;
    case Op::greater:
      return a > b ? 1.0 : 0.0;
    case Op::greater_equal:
      return a >= b ? 1.0 : 0.0;
    case Op::equal:
      return a == b ? 1.0 : 0.0;
    case Op::not_equal:
      return a != b ? 1.0 : 0.0;
    case Op::logical_and:
      return a != 0.0 && b != 0.0 ? 1.0 : 0.0;
    default:
      return a != 0.0 || b != 0.0 ? 1.0 : 0.0;
  }
}

}  // namespace

std::string Expression::parse(std::string_view text, const Lookup& lookup) {
  text_ = text;
  Parser parser(text_, lookup);
  is_condition_ = parser.read();
  steps_ = std::move(parser.steps());
  return parser.problem();
}

double Expression::value(const double* variables) const {
  std::array<double, kDeepest> stack;
  std::size_t size = 0;
  for (const Step& step : steps_) {
    switch (step.op) {
      case Op::number:
        stack[size++] = step.number;
        break;
      case Op::variable:
        stack[size++] = variables[step.variable];
        break;
      case Op::negate:
        stack[size - 1] = -stack[size - 1];
        break;
      case Op::absolute:
        stack[size - 1] = std::fabs(stack[size - 1]);
        break;
      case Op::logical_not:
        stack[size - 1] = stack[size - 1] != 0.0 ? 0.0 : 1.0;
        break;
      default:
        --size;
        stack[size - 1] = binary(step.op, stack[size - 1], stack[size]);
    }
  }
  return stack[0];
}

}  // namespace eagerx::linux_sim

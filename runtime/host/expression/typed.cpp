#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/expression/functions.hpp>
#include <runtime/host/expression/typed.hpp>
#include <utility>

namespace eagerx::expression {
namespace {

using Op = Typed::Op;
using Tree = Expression::Op;

struct Reduction {
  std::string_view name;
  Op op;
};
constexpr std::array kReductions = {Reduction{"sum", Op::sum}, Reduction{"mean", Op::mean},
                                    Reduction{"norm", Op::norm}};

std::string list_text(const std::vector<std::uint64_t>& shape) {
  std::string text;
  for (const std::uint64_t each : shape) text += (text.empty() ? "" : ", ") + std::to_string(each);
  return "a list of shape [" + text + "]";
}

std::string quoted(const std::string& text) {
  return "`" + text + "`";
}

class Typer {
 public:
  Typer(Text& text, const Names& names) : text_(text), names_(names) {}

  std::optional<Typed> read(Type wanted) {
    const auto tree = parse(text_, names_.form, true);
    if (!tree) return std::nullopt;
    Typed all = make(*tree);
    if (wanted == Type::condition) {
      expect_condition(all, tree->begin);
    } else {
      expect_number(all, tree->begin);
      if (all.is_list())
        fail(
            tree->begin, "this is " + list_text(all.shape) + ", not one number",
            "reduce it to one number with sum, norm, mean, min or max, or take an element: `x[0]`");
    }
    return text_.good() ? std::optional(std::move(all)) : std::nullopt;
  }

 private:
  void fail(std::size_t place, std::string message, std::string help = {}) {
    text_.fail(place, std::move(message), std::move(help));
  }

  static Typed number(double value) {
    Typed result;
    result.value = value;
    return result;
  }

  /// -1 is a number, as people read it.
  static Typed negated(Typed whole) {
    const Typed& operand = whole.operands[0];
    return operand.op == Op::number ? number(-operand.value) : whole;
  }

  Typed make(const Expression& tree) {
    switch (tree.op) {
      case Tree::number:
        return number(parse_digits(tree.text).value_or(0.0));
      case Tree::truth: {
        Typed result;
        result.op = Op::truth;
        result.is_condition = true;
        result.truth = tree.truth;
        return result;
      }
      case Tree::name:
      case Tree::reference:
        return single(name(tree));
      case Tree::call:
        return single(call(tree));
      case Tree::index:
        return element(tree);
      case Tree::power: {
        Typed result = element_wise(Op::power, tree, 1);
        result.count = tree.count;
        return result;
      }
      case Tree::negate:
        return negated(element_wise(Op::negate, tree, 1));
      case Tree::add:
        return element_wise(Op::add, tree, 2);
      case Tree::subtract:
        return element_wise(Op::subtract, tree, 2);
      case Tree::multiply:
        return element_wise(Op::multiply, tree, 2);
      case Tree::divide:
        return element_wise(Op::divide, tree, 2);
      case Tree::one_of:
        return membership(tree);
      case Tree::logical_and:
      case Tree::logical_or:
      case Tree::logical_not:
        return logical(tree);
      default:
        return comparison(tree);
    }
  }

  /// A list of one number is that number.
  static Typed single(Typed whole) {
    if (!whole.is_list() || whole.size() != 1) return whole;
    Typed result;
    result.op = Op::element;
    result.is_condition = whole.is_condition;
    result.operands.push_back(std::move(whole));
    return result;
  }

  Typed name(const Expression& tree) {
    if (tree.text == "pi") return number(std::numbers::pi);
    Typed result;
    if (tree.text == "time") {
      result.op = Op::time;
      return result;
    }
    result.op = Op::variable;
    const auto found = find(tree.text);
    if (found == names_.variables.end()) {
      report_unknown(tree);
      return {};
    }
    result.variable = static_cast<std::size_t>(found - names_.variables.begin());
    result.is_condition = found->is_condition;
    result.shape = found->shape;
    return result;
  }

  std::vector<Variable>::const_iterator find(const std::string& name) const {
    const auto found = std::ranges::find(names_.variables, name, &Variable::name);
    if (found != names_.variables.end() || !names_.meant) return found;
    return std::ranges::find(names_.variables, names_.meant(name), &Variable::name);
  }

  [[nodiscard]] std::vector<std::string> known_names() const {
    std::vector<std::string> known;
    for (const Variable& variable : names_.variables) known.push_back(variable.name);
    return known;
  }

  void report_unknown(const Expression& tree) {
    std::string help = names_.help ? names_.help(tree.text) : std::string();
    std::string message = "unknown name " + quoted(tree.text);
    if (!help.empty()) return fail(tree.begin, std::move(message), std::move(help));
    std::vector<std::string> known = known_names();
    known.insert(known.end(), {"time", "pi"});
    text_.fail_unknown(tree.begin, std::move(message), tree.text, known);
  }

  Typed element(const Expression& tree) {
    Typed result;
    result.op = Op::element;
    result.count = tree.count;
    const Expression& of = tree.operands[0];
    // Here one of a single number is written out.
    result.operands.push_back(of.op == Tree::name   ? name(of)
                              : of.op == Tree::call ? call(of)
                                                    : make(of));
    const Typed& list = result.operands[0];
    result.is_condition = list.is_condition;
    if (!text_.good()) return result;
    if (!list.is_list()) {
      fail(tree.begin, "this is not a list, so it has no elements",
           "write it without `[" + std::to_string(tree.count) + "]`");
    } else if (tree.count >= list.size()) {
      fail(tree.begin, list_text(list.shape) + " has no element " + std::to_string(tree.count),
           "elements are counted from 0, row by row: 0 to " + std::to_string(list.size() - 1));
    }
    return result;
  }

  /// Operands that are numbers or lists of one shape.
  Typed element_wise(Op op, const Expression& tree, std::size_t count) {
    Typed result;
    result.op = op;
    for (std::size_t i = 0; i < count; ++i) {
      result.operands.push_back(make(tree.operands[i]));
      expect_number(result.operands.back(), tree.operands[i].begin);
      join_shape(result, result.operands.back(), tree.operands[i].begin);
    }
    return result;
  }

  void join_shape(Typed& result, const Typed& operand, std::size_t place) {
    if (!operand.is_list()) return;
    if (result.is_list() && result.shape != operand.shape)
      return fail(place, list_text(operand.shape) + " does not go with " + list_text(result.shape),
                  "lists go together element by element: they need one shape");
    result.shape = operand.shape;
  }

  /// A list has no order, and is neither true nor false as a whole.
  void expect_one(const Typed& operand, std::size_t place) {
    if (operand.is_list())
      fail(place, list_text(operand.shape) + " cannot be used in a condition",
           "compare one number of it: `max(abs(x)) < 1`, `norm(x) < 1`, `x[0] < 1`");
  }

  Typed comparison(const Expression& tree) {
    Typed result;
    result.op = comparison_of(tree.op);
    result.is_condition = true;
    for (const Expression& operand : tree.operands) {
      result.operands.push_back(make(operand));
      expect_number(result.operands.back(), operand.begin);
      expect_one(result.operands.back(), operand.begin);
    }
    return result;
  }

  /// `x in (a, b)` is x == a or x == b.
  Typed membership(const Expression& tree) {
    Typed all;
    for (std::size_t i = 1; i < tree.operands.size(); ++i) {
      Expression equal;
      equal.op = Tree::equal;
      equal.begin = tree.begin;
      equal.operands = {tree.operands[0], tree.operands[i]};
      Typed one = comparison(equal);
      if (i == 1) {
        all = std::move(one);
        continue;
      }
      Typed either;
      either.op = Op::logical_or;
      either.is_condition = true;
      either.operands.push_back(std::move(all));
      either.operands.push_back(std::move(one));
      all = std::move(either);
    }
    return all;
  }

  Typed logical(const Expression& tree) {
    Typed result;
    result.op = tree.op == Tree::logical_and  ? Op::logical_and
                : tree.op == Tree::logical_or ? Op::logical_or
                                              : Op::logical_not;
    result.is_condition = true;
    for (const Expression& operand : tree.operands) {
      result.operands.push_back(make(operand));
      expect_condition(result.operands.back(), operand.begin);
      expect_one(result.operands.back(), operand.begin);
    }
    return result;
  }

  static Op comparison_of(Tree op) {
    switch (op) {
      case Tree::less:
        return Op::less;
      case Tree::less_equal:
        return Op::less_equal;
      case Tree::greater:
        return Op::greater;
      case Tree::greater_equal:
        return Op::greater_equal;
      case Tree::equal:
        return Op::equal;
      default:
        return Op::not_equal;
    }
  }

  // Functions.

  Typed call(const Expression& tree) {
    const std::string& name = tree.text;
    if (const auto found = std::ranges::find(functions(), name, &Function::name);
        found != functions().end())
      return function(tree, name, found->arguments);
    if (const auto* found = std::ranges::find(kReductions, name, &Reduction::name);
        found != kReductions.end())
      return reduction(tree, found->op);
    if (name == "min" || name == "max") return extreme(tree);
    if (name == "angle_of") return angle(tree);
    if (name == "before") return before(tree);
    if (name == "where") return choice(tree);
    std::vector<std::string> known = {"sum", "norm",     "mean",   "min",
                                      "max", "angle_of", "before", "where"};
    for (const Function& each : functions()) known.emplace_back(each.name);
    if (const std::string theirs = help_with_other_name(name, known); !theirs.empty()) {
      text_.fail(tree.begin, "unknown function " + quoted(name), theirs);
      return {};
    }
    text_.fail_unknown(tree.begin, "unknown function " + quoted(name), name, known);
    return {};
  }

  bool takes(const Expression& tree, std::size_t count, const std::string& form) {
    if (tree.operands.size() == count) return true;
    fail(tree.begin,
         quoted(tree.text) + " takes " + std::to_string(count) +
             (count == 1 ? " argument, not " : " arguments, not ") +
             std::to_string(tree.operands.size()),
         "write " + quoted(form));
    return false;
  }

  Typed function(const Expression& tree, const std::string& name, std::size_t arguments) {
    static constexpr std::array kForms = {"(x)", "(x, y)", "(x, low, high)"};
    const char* const form = name == "atan2" ? "(y, x)" : kForms[arguments - 1];
    if (!takes(tree, arguments, name + form)) return {};
    Typed result = element_wise(Op::function, tree, arguments);
    result.function = name;
    return result;
  }

  /// From cosine and sine, as an encoder or a decomposed angle gives them.
  Typed angle(const Expression& tree) {
    if (!takes(tree, 2, "angle_of(cosine, sine)")) return {};
    Typed result = element_wise(Op::function, tree, 2);
    result.function = "atan2";
    std::swap(result.operands[0], result.operands[1]);
    return result;
  }

  Typed reduction(const Expression& tree, Op op) {
    if (!takes(tree, 1, tree.text + "(x)")) return {};
    Typed result;
    result.op = op;
    result.operands.push_back(make(tree.operands[0]));
    expect_number(result.operands[0], tree.operands[0].begin);
    if (result.operands[0].is_list()) return result;
    Typed one = std::move(result.operands[0]);
    if (op != Op::norm) return one;
    Typed length;
    length.op = Op::function;
    length.function = "abs";
    length.operands.push_back(std::move(one));
    return length;
  }

  Typed extreme(const Expression& tree) {
    const bool least = tree.text == "min";
    if (tree.operands.size() == 1) return reduction(tree, least ? Op::least : Op::most);
    Typed all = element_wise(Op::function, tree, 2);
    all.function = tree.text;
    for (std::size_t i = 2; i < tree.operands.size(); ++i) {
      Typed more;
      more.op = Op::function;
      more.function = tree.text;
      more.operands.push_back(std::move(all));
      more.operands.push_back(make(tree.operands[i]));
      for (const Typed& operand : more.operands) {
        expect_number(operand, tree.operands[i].begin);
        join_shape(more, operand, tree.operands[i].begin);
      }
      all = std::move(more);
    }
    return all;
  }

  Typed before(const Expression& tree) {
    if (!takes(tree, 1, "before(x)")) return {};
    Typed result = tree.operands[0].op == Tree::name ? name(tree.operands[0]) : Typed();
    if (text_.good() && result.op != Op::variable)
      fail(tree.operands[0].begin, "`before` takes the name of an input",
           "write `before(x)[0]` for an element, `before(x)^2` for a square");
    expect_number(result, tree.operands[0].begin);
    result.op = Op::before;
    return result;
  }

  Typed choice(const Expression& tree) {
    if (!takes(tree, 3, "where(condition, x, y)")) return {};
    Typed result;
    result.op = Op::choose;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t place = tree.operands[i].begin;
      result.operands.push_back(make(tree.operands[i]));
      if (i == 0) {
        expect_condition(result.operands[0], place);
        expect_one(result.operands[0], place);
      } else {
        expect_number(result.operands[i], place);
        join_shape(result, result.operands[i], place);
      }
    }
    return result;
  }

  void expect_number(const Typed& operand, std::size_t place) {
    if (operand.is_condition)
      fail(place, "expected a number, found true or false",
           "convert it to a number: `where(x < 1, 1, 0)`");
  }
  void expect_condition(const Typed& operand, std::size_t place) {
    if (!operand.is_condition)
      fail(place, "expected true or false, found a number", "compare it: `x > 0`");
  }

  Text& text_;
  const Names& names_;
};

}  // namespace

std::uint64_t Typed::size() const {
  return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

std::optional<Typed> read_typed(Text& text, const Names& names, Type wanted) {
  return Typer(text, names).read(wanted);
}

bool varies(const Typed& expression) {
  bool result = false;
  for_each_part(expression, [&](const Typed& part) {
    result = result || part.op == Op::variable || part.op == Op::before || part.op == Op::time;
  });
  return result;
}

}  // namespace eagerx::expression

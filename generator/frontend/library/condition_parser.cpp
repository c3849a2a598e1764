// Conditions from their text, with types checked on the way.
#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/expression/expression.hpp"
#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/dtype.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

using Op = ConditionStep::Op;
using Tree = Expression::Op;

/// The type of an operand.
struct Type {
  enum class Kind : std::uint8_t { number, boolean, list, text, word };
  Kind kind = Kind::number;
  const std::vector<std::string>* choices = nullptr;  // text: what it can be; nullptr: anything
  std::string word;                                   // a choice, still without its parameter
  std::size_t begin = 0;                              // where in the text
};

std::string_view to_string(Type::Kind kind) {
  switch (kind) {
    case Type::Kind::number:
      return "a number";
    case Type::Kind::boolean:
      return "true or false";
    case Type::Kind::list:
      return "a list";
    case Type::Kind::text:
    case Type::Kind::word:
      return "a text";
  }
  return "";
}

/// The steps of a tree, with types checked on the way.
class Maker {
 public:
  Maker(const YamlValue& yaml, const char* code, Diagnostics& diagnostics)
      : text_(yaml.text), yaml_(yaml), code_(code), diagnostics_(diagnostics) {}
  virtual ~Maker() = default;
  Maker(const Maker&) = delete;
  Maker& operator=(const Maker&) = delete;

  std::optional<Condition> read(NameForm names, Type::Kind kind) {
    if (const auto tree = expression::parse(text_, names)) expect(make(*tree), kind);
    if (report_problem(text_, yaml_, code_, diagnostics_)) return std::nullopt;
    return std::move(steps_);
  }

 protected:
  // Names in the two kinds of text.

  virtual Type name(const Expression& word) = 0;
  /// A function of a port: size, window, dtype.
  virtual Type port_fact(const Expression& call) = 0;
  /// A name that means nothing.
  virtual void unknown(const Type& word) = 0;

  Type make(const Expression& tree) {
    switch (tree.op) {
      case Tree::number:
        return result({Op::constant, constant(exact_number(tree)), {}, {}, 0}, Type::Kind::number,
                      tree.begin);
      case Tree::truth:
        return result({Op::constant, tree.truth, {}, {}, 0}, Type::Kind::boolean, tree.begin);
      case Tree::name:
      case Tree::reference:
        return name(tree);
      case Tree::call:
        return call(tree);
      case Tree::index:
        text_.fail(tree.begin, "elements have no place here");
        return {};
      case Tree::power:
        return power(tree);
      case Tree::negate:
        return unary(Op::negate, Type::Kind::number, tree);
      case Tree::logical_not:
        return unary(Op::logical_not, Type::Kind::boolean, tree);
      case Tree::one_of:
        return membership(tree);
      default:
        return binary(tree);
    }
  }

  Type unary(Op op, Type::Kind kind, const Expression& tree) {
    const Type operand = make(tree.operands[0]);
    expect(operand, kind);
    return result({op, {}, {}, {}, 1}, kind, operand.begin);
  }

  Type power(const Expression& tree) {
    for (std::uint32_t i = 0; i < tree.count; ++i) {
      expect(make(tree.operands[0]), Type::Kind::number);
      if (i > 0) result({Op::multiply, {}, {}, {}, 2}, Type::Kind::number, tree.begin);
    }
    return {Type::Kind::number, nullptr, {}, tree.begin};
  }

  Type membership(const Expression& tree) {
    const Type left = make(tree.operands[0]);
    for (std::size_t i = 1; i < tree.operands.size(); ++i)
      check_comparable(Op::equal, left, make(tree.operands[i]));
    return result({Op::one_of, {}, {}, {}, tree.operands.size() - 1}, Type::Kind::boolean,
                  left.begin);
  }

  Type binary(const Expression& tree) {
    const Op op = op_of(tree.op);
    const Type left = make(tree.operands[0]);
    const Type right = make(tree.operands[1]);
    const bool joins = op == Op::logical_and || op == Op::logical_or;
    const bool compares = op >= Op::less && op <= Op::not_equal;
    if (compares) {
      check_comparable(op, left, right);
    } else {
      const Type::Kind kind = joins ? Type::Kind::boolean : Type::Kind::number;
      expect(left, kind);
      expect(right, kind);
    }
    return result({op, {}, {}, {}, 2}, joins || compares ? Type::Kind::boolean : Type::Kind::number,
                  left.begin);
  }

  Type call(const Expression& tree) {
    const std::string& function = tree.text;
    if (function == "min" || function == "max")
      return extreme(function == "min" ? Op::least : Op::most, tree);
    if (function == "abs") return takes_one(tree), unary(Op::absolute, Type::Kind::number, tree);
    if (function == "size" || function == "window" || function == "dtype") {
      takes_one(tree);
      return text_.good() ? port_fact(tree) : Type();
    }
    if (function != "len" && function != "increasing") {
      text_.fail_unknown(tree.begin, fmt::format("unknown function `{}`", function), function,
                         {"abs", "min", "max", "len", "increasing", "size", "window", "dtype"});
      return {};
    }
    takes_one(tree);
    expect(make(tree.operands[0]), Type::Kind::list);
    const bool counts = function == "len";
    return result({counts ? Op::length : Op::increasing, {}, {}, {}, 1},
                  counts ? Type::Kind::number : Type::Kind::boolean, tree.begin);
  }

  void takes_one(const Expression& tree) {
    if (tree.operands.size() != 1)
      text_.fail(tree.operands[1].begin, fmt::format("`{}` takes one argument", tree.text));
  }

  Type extreme(Op op, const Expression& tree) {
    for (const Expression& operand : tree.operands) {
      const Type argument = make(operand);
      if (argument.kind != Type::Kind::list) expect(argument, Type::Kind::number);
    }
    return result({op, {}, {}, {}, tree.operands.size()}, Type::Kind::number, tree.begin);
  }

  // Types.

  void expect(const Type& type, Type::Kind kind) {
    if (type.kind == kind || !text_.good()) return;
    if (type.kind == Type::Kind::word) return unknown(type);
    text_.fail(type.begin,
               fmt::format("expected {}, found {}", to_string(kind), to_string(type.kind)));
  }

  void check_comparable(Op op, const Type& left, const Type& right) {
    if (!text_.good()) return;
    const bool equality = op == Op::equal || op == Op::not_equal;
    const bool wrong =
        left.kind == Type::Kind::list ||
        (left.kind != Type::Kind::number && left.kind != Type::Kind::word && !equality);
    if (wrong)
      text_.fail(left.begin, fmt::format("{} cannot be compared like this", to_string(left.kind)));
    if (left.kind == Type::Kind::word)
      return right.kind == Type::Kind::text && equality ? check_choice(left, right) : unknown(left);
    if (right.kind == Type::Kind::word && left.kind == Type::Kind::text)
      return check_choice(right, left);
    expect(right, left.kind);
  }

  void check_choice(const Type& word, const Type& text) {
    if (text.choices == nullptr || contains(*text.choices, word.word)) return;
    text_.fail_unknown(word.begin, fmt::format("`{}` is not one of its choices", word.word),
                       word.word, *text.choices);
  }

  Type result(ConditionStep step, Type::Kind kind, std::size_t begin) {
    if (text_.good()) steps_.push_back(std::move(step));
    return {kind, nullptr, {}, begin};
  }

  static ConditionValue constant(const ExpressionNumber& number) {
    return std::visit([](auto value) { return ConditionValue(value); }, number);
  }

  static Op op_of(Tree op) {
    switch (op) {
      case Tree::add:
        return Op::add;
      case Tree::subtract:
        return Op::subtract;
      case Tree::multiply:
        return Op::multiply;
      case Tree::divide:
        return Op::divide;
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
      case Tree::not_equal:
        return Op::not_equal;
      case Tree::logical_and:
        return Op::logical_and;
      default:
        return Op::logical_or;
    }
  }

  ExpressionText text_;
  const YamlValue& yaml_;
  const char* code_;
  Diagnostics& diagnostics_;
  Condition steps_;
};

/// Of an entity: its parameters, ports and rate.
class ConditionMaker : public Maker {
 public:
  ConditionMaker(const YamlValue& yaml, const Entity& entity, Diagnostics& diagnostics)
      : Maker(yaml, "E0207", diagnostics), entity_(entity) {}

 private:
  /// A parameter, the node's rate, or a choice.
  Type name(const Expression& tree) override {
    const std::string& word = tree.text;
    const std::size_t begin = tree.begin;
    if (const Parameter* found = find_named(entity_.config, word)) {
      Type type = result({Op::fact, {}, word, word, 0}, kind_of(*found), begin);
      if (found->type == Parameter::Type::keyword) type.choices = &found->options;
      return type;
    }
    if (word == "rate" && has_rate())
      return result({Op::fact, {}, word, word, 0}, Type::Kind::number, begin);
    Type type = result({Op::constant, word, {}, {}, 0}, Type::Kind::word, begin);
    type.word = word;
    return type;
  }

  Type port_fact(const Expression& call) override {
    const std::string& function = call.text;
    const std::size_t begin = call.begin, port_begin = call.operands[0].begin;
    const std::string& written = call.operands[0].text;
    const std::string port = find_port(written, port_begin);
    if (function == "window" && !port.starts_with("inputs."))
      text_.fail(port_begin, fmt::format("`{}` is not an input", written));
    Type type = result({Op::fact,
                        {},
                        fmt::format("{}({})", function, port),
                        fmt::format("{}({})", function, written),
                        0},
                       function == "dtype" ? Type::Kind::text : Type::Kind::number, begin);
    if (function == "dtype") type.choices = &dtype_names();
    return type;
  }

  /// The port with its group: "inputs.signal".
  std::string find_port(const std::string& written, std::size_t begin) {
    std::vector<std::string> known, found;
    const auto collect = [&](const char* group, const std::vector<PortManifest>& ports) {
      for (const auto& port : ports) {
        const std::string full = fmt::format("{}.{}", group, port.name.value);
        known.push_back(port.name.value);
        if (written == port.name.value || written == full) found.push_back(full);
      }
    };
    collect("inputs", entity_.inputs);
    collect("outputs", entity_.outputs);
    collect("states", entity_.states);
    if (found.empty()) {
      text_.fail_unknown(begin, fmt::format("there is no input, output or state `{}`", written),
                         written, known);
    } else if (found.size() > 1) {
      text_.fail(begin, fmt::format("`{}` could be two ports", written),
                 fmt::format("write {}", join(found, " or ")));
    }
    return found.empty() ? "" : found.front();
  }

  static Type::Kind kind_of(const Parameter& parameter) {
    switch (parameter.type) {
      case Parameter::Type::boolean:
        return Type::Kind::boolean;
      case Parameter::Type::text:
      case Parameter::Type::keyword:
      case Parameter::Type::model:
        return Type::Kind::text;
      case Parameter::Type::integers:
      case Parameter::Type::numbers:
        return Type::Kind::list;
      default:
        return Type::Kind::number;
    }
  }

  [[nodiscard]] bool has_rate() const {
    return entity_.kind == EntityKind::node || entity_.kind == EntityKind::engine ||
           entity_.kind == EntityKind::engine_node;
  }

  void unknown(const Type& word) override {
    std::vector<std::string> known;
    for (const auto& parameter : entity_.config) known.push_back(parameter.name.value);
    if (has_rate()) known.emplace_back("rate");
    text_.fail_unknown(word.begin, fmt::format("unknown name `{}`", word.word), word.word, known);
  }

  const Entity& entity_;
};

/// Of an object or engine node: what its manifest refers to with `$(…)`.
class ExpressionMaker : public Maker {
 public:
  ExpressionMaker(const YamlValue& yaml, const KnownReferences& references,
                  Diagnostics& diagnostics)
      : Maker(yaml, "E0324", diagnostics), references_(references) {}

 private:
  Type name(const Expression& tree) override {
    const auto found = references_.find(tree.text);
    if (found == references_.end() || tree.op == Tree::name) {
      report(tree);
      return {};
    }
    return result({Op::fact, {}, tree.text, tree.text, 0}, kind_of(found->second), tree.begin);
  }

  void report(const Expression& tree) {
    const std::string& reference = tree.text;
    if (tree.op == Tree::name)
      return text_.fail(tree.begin, fmt::format("`{}` is not a number", reference),
                        "references stand inside of `$(…)`");
    std::vector<std::string> known;
    for (const auto& [name, value] : references_) known.push_back(name);
    text_.fail(tree.begin, fmt::format("`{}` refers to nothing", reference),
               did_you_mean(reference, known).text);
  }

  Type port_fact(const Expression& call) override {
    text_.fail_unknown(call.begin, fmt::format("unknown function `{}`", call.text), call.text,
                       {"abs", "min", "max", "len"});
    return {};
  }

  void unknown(const Type& /*word*/) override {}  // every name is a reference, or reported

  static Type::Kind kind_of(const std::optional<ConditionValue>& value) {
    if (!value) return Type::Kind::number;  // said elsewhere why it is not known
    if (std::holds_alternative<bool>(*value)) return Type::Kind::boolean;
    if (std::holds_alternative<std::string>(*value)) return Type::Kind::text;
    return std::holds_alternative<std::vector<ConditionNumber>>(*value) ? Type::Kind::list
                                                                        : Type::Kind::number;
  }

  const KnownReferences& references_;
};

}  // namespace

std::optional<Condition> read_condition(const YamlValue& text, const Entity& entity,
                                        Diagnostics& diagnostics) {
  return ConditionMaker(text, entity, diagnostics).read(NameForm::plain, Type::Kind::boolean);
}

std::optional<Condition> read_expression(const YamlValue& text, const KnownReferences& references,
                                         Diagnostics& diagnostics) {
  return ExpressionMaker(text, references, diagnostics).read(NameForm::dollar, Type::Kind::number);
}

}  // namespace eagerx::gen
